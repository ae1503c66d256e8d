// SPDX-License-Identifier: MIT
#include "core/photometry/planck.h"

#include <algorithm>
#include <cmath>

#include <glm/mat3x3.hpp>

#include "core/photometry/cie1931.h"
#include "core/photometry/constants.h"

namespace blackhole {

namespace {

constexpr double kMetresPerNm = 1e-9;
constexpr double kLastWavelength = (kCieFirstNm + kCieStepNm * (kCieSamples - 1)) * kMetresPerNm;

/// From CIE XYZ to linear Rec.709 with white D65 (0.3127, 0.3290); columns.
constexpr glm::dmat3 kRec709OfXyz = {3.2409699419045213, -0.9692436362808798, 0.0556300796969936, //
		-1.5373831775700935, 1.8759675015077206, -0.2039769588889765,                             //
		-0.4986107602930033, 0.0415550574071756, 1.0569715142428784};

} // namespace

PlanckLight planck_light(double p_temperature) {
	// With x = c2/(lambda T): 1/(e^x - 1) = e^-x_last e^(x_last - x)/(1 - e^-x); towards infinite T it is
	// 1/x, and the factor T goes into the logarithm.
	const double x_last = kSecondRadiationConstant / (kLastWavelength * p_temperature);
	glm::dvec3 sum(0.0);
	for (std::size_t i = 0; i < kCieSamples; ++i) {
		const double wavelength = (kCieFirstNm + kCieStepNm * static_cast<double>(i)) * kMetresPerNm;
		const double ratio = kLastWavelength / wavelength;
		const double x = x_last * ratio;
		const double occupation = x > 0.0 ? x_last * std::exp(x_last - x) / -std::expm1(-x) : 1.0 / ratio;
		const double radiance = ratio * ratio * ratio * ratio * ratio * occupation;
		sum += radiance * glm::dvec3(kCie1931[i].x, kCie1931[i].y, kCie1931[i].z);
	}
	const double unit = kLuminousEfficacy * kFirstRadiationConstant / std::pow(kLastWavelength, 5.0) *
			kCieStepNm * kMetresPerNm;
	return {std::log(unit * sum.y) - x_last - std::log(x_last), sum / sum.y};
}

double planck_luminance_log10(double p_temperature) {
	return planck_light(p_temperature).ln_luminance / std::log(10.0);
}

glm::dvec2 planck_chromaticity(double p_temperature) {
	const glm::dvec3 xyz = planck_light(p_temperature).xyz;
	const double sum = xyz.x + xyz.y + xyz.z;
	return {xyz.x / sum, xyz.y / sum};
}

glm::dvec3 desaturated(glm::dvec3 p_rgb) {
	const double least = std::min({p_rgb.x, p_rgb.y, p_rgb.z});
	return least >= 0.0 ? p_rgb : glm::max(1.0 + (p_rgb - 1.0) / (1.0 - least), 0.0);
}

glm::dvec3 rec709_of_xyz(glm::dvec3 p_xyz) {
	return kRec709OfXyz * p_xyz;
}

glm::dvec3 planck_rgb(double p_temperature) {
	return desaturated(rec709_of_xyz(planck_light(p_temperature).xyz));
}

} // namespace blackhole
