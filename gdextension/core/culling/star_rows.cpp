// SPDX-License-Identifier: MIT
#include "core/culling/star_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/photometry/radiometry.h"

namespace blackhole {
namespace {

constexpr double kLog2PerMagnitude = -1.3287712379549449; // -0.4 log2(10)
constexpr std::size_t kBlock = 64;

} // namespace

void pack_rows(const StarTable &table, const std::vector<glm::dvec3> &directions, const StarGroup &group,
		const PlanckTable &planck, float *rows) {
	// star_angular_radius() with what all stars have in common taken out.
	const double radius_of_zero = star_angular_radius(0.0, 1e4, planck);
	const double log_of_zero = planck.log2_luminance(1e4);
	// A group's stars lie far apart in the table. Fetching some before working on them lets the processor
	// wait for all of them at once.
	struct Fetched {
		glm::dvec3 direction;
		float v_magnitude;
		float temperature_k;
	};
	std::array<Fetched, kBlock> block{};
	for (std::size_t first = 0; first < group.stars.size(); first += kBlock) {
		const std::size_t count = std::min(kBlock, group.stars.size() - first);
		for (std::size_t i = 0; i < count; ++i) {
			const std::uint32_t member = group.stars[first + i];
			const Star &star = table.stars[member];
			block[i] = {directions[member], star.v_magnitude, star.temperature_k};
		}
		for (std::size_t i = 0; i < count; ++i) {
			const Fetched &star = block[i];
			const double log_flux = kLog2PerMagnitude * star.v_magnitude;
			const double log_luminance = planck.log2_luminance(star.temperature_k);
			const double radius = radius_of_zero * std::exp2(0.5 * (log_flux + log_of_zero - log_luminance));
			const std::array<float, kFloatsPerStar> row = {static_cast<float>(std::exp2(log_flux)),
					static_cast<float>(radius), 0.0F, static_cast<float>(star.direction.x),
					star.temperature_k, star.v_magnitude, 0.0F, static_cast<float>(star.direction.y),
					static_cast<float>(log_luminance), 0.0F, 0.0F, static_cast<float>(star.direction.z)};
			rows = std::copy(row.begin(), row.end(), rows);
		}
	}
}

} // namespace blackhole
