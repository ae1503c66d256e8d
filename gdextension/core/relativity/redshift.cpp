// SPDX-License-Identifier: MIT
#include "core/relativity/redshift.h"

#include "core/relativity/light_ray.h"

namespace blackhole {

double radial_redshift(double u, double y, double kappa) {
	const LightRay<double> ray(u, y);
	return 0.5 * u * (kappa / ray.sigma + ray.sigma / kappa) / ray.a;
}

} // namespace blackhole
