// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/catalogue/star.h"

namespace blackhole {

/// Stars of like brightness in one part of the sky: what is drawn, or left out, as a whole.
struct StarGroup {
	std::vector<std::uint32_t> stars; ///< places in StarTable::stars, brightest first
	glm::dvec3 centre{0.0};                ///< unit vector, ICRS axes
	double angular_radius = 0.0;      ///< radians; every star lies within it of the centre
	float brightest_v = 0.0F;         ///< V of the first star
	float coolest_k = 0.0F;           ///< lowest temperature, kelvin
	float hottest_k = 0.0F;           ///< highest temperature, kelvin
};

/// Divides a catalogue (brightest first) into at most 127 groups: the 1,024 brightest stars over the whole
/// sky, the next 7,168 by cube faces, the next 24,576 by quarter faces and the rest by sixteenths, so that
/// faint stars, the many, are known to lie in small cells. A star belongs to one group only.
std::vector<StarGroup> group_stars(const StarTable &table);

} // namespace blackhole
