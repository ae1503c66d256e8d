// SPDX-License-Identifier: MIT
#include "core/overlay/cube_map.h"

#include <glm/geometric.hpp>

namespace blackhole {

glm::dvec3 cube_point(int face, double s, double t) {
	switch (face) {
		case 0:
			return {1.0, -t, -s};
		case 1:
			return {-1.0, -t, s};
		case 2:
			return {s, 1.0, t};
		case 3:
			return {s, -1.0, -t};
		case 4:
			return {s, -t, 1.0};
		default:
			return {-s, -t, -1.0};
	}
}

glm::dvec3 texel_direction(int face, int column, int row, int size) {
	return glm::normalize(
			cube_point(face, (2.0 * column + 1.0) / size - 1.0, (2.0 * row + 1.0) / size - 1.0));
}

} // namespace blackhole
