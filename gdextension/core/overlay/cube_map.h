// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace blackhole {

/// Faces of a cube map in their usual order: +x, -x, +y, -y, +z, -z.
inline constexpr int kCubeFaces = 6;

/// The point of a face (0 to 5) at s, t on the face's plane, one unit from the centre; both run from -1 to 1
/// on the face, t downwards, as OpenGL and Vulkan have it (OpenGL 4.6, table 8.19). Not normalised.
glm::dvec3 cube_point(int face, double s, double t);

/// The unit vector to the middle of a texel of a face with `size` texels a side; row 0 is the first in
/// memory.
glm::dvec3 texel_direction(int face, int column, int row, int size);

} // namespace blackhole
