// SPDX-License-Identifier: MIT
#include "core/relativity/magnification.h"

#include "core/relativity/critical.h"

#include <cmath>

namespace blackhole {

double radial_magnification(double u, ImageDirection image, double kappa, double sin_phi) {
	// 4 kappa^2 sigma |dsigma/dPhi| / ((kappa^2 + sigma^2)^2 sin phi), ordered so that sigma may be huge
	const double sigma = critical_sigma(u) + image.y;
	const double half_sine = kappa / (kappa * (kappa / sigma) + sigma);
	return 4.0 * half_sine * half_sine * (std::abs(image.slope) / sigma) / sin_phi;
}

} // namespace blackhole
