// SPDX-License-Identifier: MIT
#include "tests/overlay/cube_sampler.h"

#include "core/overlay/cube_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace blackhole {
namespace {

glm::dvec4 texel(const FigureField &field, int face, int column, int row) {
	const std::size_t place = (std::size_t(face) * field.size + row) * field.size + column;
	const float *at = field.texels.data() + 4 * place;
	return {at[0], at[1], at[2], at[3]};
}

bool is_inside(int index, int size) {
	return index >= 0 && index < size;
}

/// The texel at these indices, of the neighbouring face where one of them is past the edge.
glm::dvec4 texel_across(const FigureField &field, int face, int column, int row) {
	if (is_inside(column, field.size) && is_inside(row, field.size)) {
		return texel(field, face, column, row);
	}
	const auto just_past = [&field](int index) {
		return std::clamp((2.0 * index + 1.0) / field.size - 1.0, -1.0 - 1e-9, 1.0 + 1e-9);
	};
	const CubePlace place = cube_place(cube_point(face, just_past(column), just_past(row)), field.size);
	const auto whole = [&field](double value) {
		return std::clamp(int(std::floor(value)), 0, field.size - 1);
	};
	return texel(field, place.face, whole(place.column), whole(place.row));
}

} // namespace

CubePlace cube_place(const glm::dvec3 &direction, int size) {
	const double x = direction.x;
	const double y = direction.y;
	const double z = direction.z;
	const double greatest = std::max({std::abs(x), std::abs(y), std::abs(z)});
	int face = 0;
	double s = 0.0;
	double t = 0.0;
	if (std::abs(z) == greatest) {
		face = z < 0.0 ? 5 : 4;
		s = z < 0.0 ? -x : x;
		t = -y;
	} else if (std::abs(y) == greatest) {
		face = y < 0.0 ? 3 : 2;
		s = x;
		t = y < 0.0 ? -z : z;
	} else {
		face = x < 0.0 ? 1 : 0;
		s = x < 0.0 ? z : -z;
		t = -y;
	}
	return {face, 0.5 * (s / greatest + 1.0) * size, 0.5 * (t / greatest + 1.0) * size};
}

bool takes_two_faces(const glm::dvec3 &direction, int size) {
	const CubePlace place = cube_place(direction, size);
	return std::min(place.column, place.row) < 0.5 || std::max(place.column, place.row) > size - 0.5;
}

glm::dvec4 sample(const FigureField &field, const glm::dvec3 &direction) {
	const CubePlace place = cube_place(direction, field.size);
	const int column = int(std::floor(place.column - 0.5));
	const int row = int(std::floor(place.row - 0.5));
	const double right = place.column - 0.5 - column;
	const double down = place.row - 0.5 - row;
	glm::dvec4 sum(0.0);
	double weights = 0.0;
	for (const int dx : {0, 1}) {
		for (const int dy : {0, 1}) {
			// Three faces meet at a corner of the cube: there is no fourth texel, the others stand in for it.
			if (!is_inside(column + dx, field.size) && !is_inside(row + dy, field.size)) {
				continue;
			}
			const double weight = (dx == 1 ? right : 1.0 - right) * (dy == 1 ? down : 1.0 - down);
			sum += weight * texel_across(field, place.face, column + dx, row + dy);
			weights += weight;
		}
	}
	return sum / weights;
}

double sampled_distance(const FigureField &field, const glm::dvec3 &direction) {
	const glm::dvec4 at = sample(field, direction);
	return std::max(glm::length(glm::dvec3(at)), at.w - field.margin);
}

} // namespace blackhole
