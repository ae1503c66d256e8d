// SPDX-License-Identifier: MIT
#include "core/photometry/radiometry.h"

#include <cmath>
#include <numbers>

#include "core/photometry/constants.h"
#include "core/photometry/planck.h"

namespace blackhole {

double pixel_solid_angle(double p_vertical_fov, int p_rows, glm::dvec2 p_tangent) {
	const double side = 2.0 * std::tan(0.5 * p_vertical_fov) / p_rows;
	const double secant_squared = 1.0 + p_tangent.x * p_tangent.x + p_tangent.y * p_tangent.y;
	return side * side / (secant_squared * std::sqrt(secant_squared));
}

double star_luminance_sum(double p_v_magnitude, double p_pixel_solid_angle) {
	return kStarGain * kReferenceSolidAngle / p_pixel_solid_angle * std::pow(10.0, -0.4 * p_v_magnitude);
}

double surface_luminance(double p_magnitude) {
	return kStarGain * kReferenceSolidAngle / kSquareArcsecond * std::pow(10.0, -0.4 * p_magnitude);
}

double log2_luminance_unit() {
	constexpr double kSolidAngle = std::numbers::pi * kSolarAngularRadius * kSolarAngularRadius;
	static const double kUnit = std::log2(star_luminance_sum(kSolarMagnitude, kSolidAngle)) -
			planck_light(kSolarTemperature).ln_luminance * std::numbers::log2e;
	return kUnit;
}

double star_angular_radius(double p_v_magnitude, double p_temperature, const PlanckTable &p_planck) {
	const double log2_brightness =
			p_planck.log2_luminance(p_temperature) - p_planck.log2_luminance(kSolarTemperature);
	return kSolarAngularRadius * std::pow(10.0, -0.2 * (p_v_magnitude - kSolarMagnitude)) *
			std::exp2(-0.5 * log2_brightness);
}

} // namespace blackhole
