// SPDX-License-Identifier: MIT
#include "core/photometry/planck_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/photometry/planck.h"

namespace blackhole {

namespace {

constexpr double kLast = static_cast<double>(kPlanckTableSize - 1);
constexpr double kHottestFinite = 1e12;

/// The part of log2 Y that the table leaves out, p_temperature in kelvin.
double leading_log2(double p_temperature) {
	return std::log2(1.0 + p_temperature / PlanckTable::kTheta) -
			std::numbers::log2e * PlanckTable::kTheta / p_temperature;
}

} // namespace

PlanckTable::PlanckTable() : m_texels(4 * kPlanckTableSize) {
	for (std::size_t i = 0; i < kPlanckTableSize; ++i) {
		const double s = static_cast<double>(i) / kLast;
		// The first texel stands for infinite temperature, where the remainder has a limit.
		const double temperature = i == 0 ? kHottestFinite : (kCoolest + kKnee) / s - kKnee;
		const PlanckLight light = planck_light(temperature);
		const glm::dvec3 rgb = rec709_of_xyz(light.xyz);
		m_texels[4 * i] = static_cast<float>(rgb.x);
		m_texels[4 * i + 1] = static_cast<float>(rgb.y);
		m_texels[4 * i + 2] = static_cast<float>(rgb.z);
		m_texels[4 * i + 3] =
				static_cast<float>(light.ln_luminance * std::numbers::log2e - leading_log2(temperature));
	}
}

double PlanckTable::log2_luminance(double p_temperature) const {
	const double temperature = std::clamp(p_temperature, 1.0, kHottestFinite);
	const double place = kLast * std::min((kCoolest + kKnee) / (temperature + kKnee), 1.0);
	const auto left = std::min(static_cast<std::size_t>(place), kPlanckTableSize - 2);
	const double rest = std::lerp(double{m_texels[4 * left + 3]}, double{m_texels[4 * left + 7]},
			place - static_cast<double>(left));
	return rest + leading_log2(temperature);
}

std::vector<float> bake_planck_table() {
	return PlanckTable().texels();
}

} // namespace blackhole
