// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// Frequency ratio g = nu_observed/nu_infinity of the light ray sigma = sigma_c(u) + y for a radially moving
/// observer with the given kappa: g = (kappa^2 + sigma^2) u / (2 kappa sigma a). Equals 1/sqrt(1-u) for
/// static observers and 1/(1 - sqrt(u) cos xi) for rain, without their cancellations. Any other observer:
/// multiply rain's g by doppler_factor().
double radial_redshift(double u, double y, double kappa);

} // namespace blackhole
