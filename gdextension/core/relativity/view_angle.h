// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// Angles xi [rad] in an observer's own frame, from the direction to the hole (0 = at it, pi = away):
/// tan(xi/2) = sigma/kappa, with kappa from observer.h.

/// xi of the ray with sigma = sigma_c(u) + y.
double view_angle(double u, double y, double kappa);

/// xi - xi_shadow of that ray, with its own relative precision.
double view_angle_beyond_shadow(double u, double y, double kappa);

/// dxi/dsigma of that ray at fixed place and motion.
double view_angle_slope(double u, double y, double kappa);

/// The y = sigma - sigma_c of the viewing direction xi for a static observer or for rain; negative inside the
/// shadow. The difference is formed in quadruple precision, so that xi counts as an exact number even close
/// to the shadow, where double precision would leave nothing of it. Slow (microseconds): not for rendering.
double static_sigma_offset(double u, double xi);
double rain_sigma_offset(double u, double xi);

} // namespace blackhole
