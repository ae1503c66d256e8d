// SPDX-License-Identifier: MIT
#include "core/culling/star_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "core/photometry/radiometry.h"

namespace blackhole {
namespace {

constexpr double kLog2PerMagnitude = -1.3287712379549449; // -0.4 log2(10)

} // namespace

void pack_rows(const StarTable &table, const std::vector<glm::dvec3> &directions, const StarGroup &group,
		const PlanckTable &planck, float *rows) {
	// star_angular_radius() with what all stars have in common taken out.
	const double radius_of_zero = star_angular_radius(0.0, 1e4, planck);
	const double log_of_zero = planck.log2_luminance(1e4);
	for (const std::uint32_t member : group.stars) {
		const Star &star = table.stars[member];
		const glm::dvec3 &direction = directions[member];
		const double log_flux = kLog2PerMagnitude * star.v_magnitude;
		const double log_luminance = planck.log2_luminance(star.temperature_k);
		const double radius = radius_of_zero * std::exp2(0.5 * (log_flux + log_of_zero - log_luminance));
		const std::array<float, kFloatsPerStar> row = {static_cast<float>(std::exp2(log_flux)),
				static_cast<float>(radius), 0.0F, static_cast<float>(direction.x), star.temperature_k,
				star.v_magnitude, 0.0F, static_cast<float>(direction.y), static_cast<float>(log_luminance),
				0.0F, 0.0F, static_cast<float>(direction.z)};
		rows = std::copy(row.begin(), row.end(), rows);
	}
}

} // namespace blackhole
