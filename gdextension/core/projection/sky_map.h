// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace blackhole {

/// Maps of the whole sky, as map_projection.gdshaderinc draws them (compiled here from that very file): its
/// MAP_... numbers, 1 to 6.
class SkyMap {
public:
	explicit SkyMap(int p_map) : map(p_map) {}

	/// Where a unit direction in view space (x right, y up, -z along the axis) is in a picture of this size,
	/// pixels from the top left corner; nothing where the map does not show it. Single precision: 1e-3
	/// pixels.
	[[nodiscard]] std::optional<glm::vec2> pixel(glm::vec3 direction, glm::vec2 picture) const;
	/// The direction shown at a pixel; nothing outside of the map.
	[[nodiscard]] std::optional<glm::vec3> direction(glm::vec2 pixel, glm::vec2 picture) const;

private:
	int map;
};

} // namespace blackhole
