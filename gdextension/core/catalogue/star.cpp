// SPDX-License-Identifier: MIT
#include "core/catalogue/star.h"

#include <algorithm>
#include <cmath>

namespace blackhole {

std::size_t StarTable::count_to(double p_v_magnitude) const {
	// Magnitudes are stored as floats: 6.3 must include a star of 6.3F, which is a little more.
	const auto limit = static_cast<float>(p_v_magnitude);
	const auto end = std::partition_point(
			stars.begin(), stars.end(), [limit](const Star &p_star) { return p_star.v_magnitude <= limit; });
	return static_cast<std::size_t>(end - stars.begin());
}

void StarTable::sort_by_magnitude() {
	const auto brighter = [](const Star &p_a, const Star &p_b) { return p_a.v_magnitude < p_b.v_magnitude; };
	if (!std::is_sorted(stars.begin(), stars.end(), brighter)) {
		std::stable_sort(stars.begin(), stars.end(), brighter);
	}
}

glm::dvec3 world_direction(double p_right_ascension, double p_declination) {
	const double c = std::cos(p_declination);
	return {c * std::cos(p_right_ascension), std::sin(p_declination), -c * std::sin(p_right_ascension)};
}

glm::dvec3 world_direction(const Star &p_star) {
	return world_direction(p_star.right_ascension, p_star.declination);
}

} // namespace blackhole
