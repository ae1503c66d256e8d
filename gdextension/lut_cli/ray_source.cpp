// SPDX-License-Identifier: MIT
#include "lut_cli/ray_source.h"

#include <limits>

namespace blackhole {

ImageDirection TabulatedRays::image(double u, double phi) const {
	const ShaderLensing::Ray ray = shader.ray_of_angle(u, phi);
	return {ray.clearance, ray.slope};
}

OrbitalAngle TabulatedRays::angle(double u, double y) const {
	if (!(y > 0.0)) { // captured
		constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
		return {kNaN, kNaN, kNaN};
	}
	const ShaderLensing::Angle result = shader.angle_of_ray(u, y);
	return {result.phi, result.slope, 0.0};
}

} // namespace blackhole
