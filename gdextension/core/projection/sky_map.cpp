// SPDX-License-Identifier: MIT
#include "core/projection/sky_map.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace blackhole {

namespace {

using namespace glm; // NOLINT(google-build-using-namespace)

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#include "map_projection_source.inc" // map_projection.gdshaderinc, see tables/sources.cmake
#pragma GCC diagnostic pop

} // namespace

std::optional<glm::vec2> SkyMap::pixel(glm::vec3 direction, glm::vec2 picture) const {
	const MapPlace at = map_place(map, direction, 0);
	if (!at.shown || !map_inside(map, at.place)) {
		return std::nullopt;
	}
	const float scale = map_scale(map, picture);
	return glm::vec2(0.5F * picture.x + at.place.x * scale, 0.5F * picture.y - at.place.y * scale);
}

std::optional<glm::vec3> SkyMap::direction(glm::vec2 pixel, glm::vec2 picture) const {
	const float scale = map_scale(map, picture);
	const glm::vec2 place((pixel.x - 0.5F * picture.x) / scale, (0.5F * picture.y - pixel.y) / scale);
	if (!map_inside(map, place)) {
		return std::nullopt;
	}
	return map_direction(map, place);
}

} // namespace blackhole
