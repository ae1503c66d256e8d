// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/overlay/figure_field.h"

namespace blackhole {

/// Where a direction falls on a cube map: the rule by which GPUs choose the face (Vulkan 1.3, "Cube Map Face
/// Selection and Transformations"), written down apart from core's own.
struct CubePlace {
	int face = 0;
	double column = 0.0; ///< texels from the left edge, middles at .5
	double row = 0.0;
};

CubePlace cube_place(const glm::dvec3 &direction, int size);

/// Whether a bilinear sample takes texels of more than one face. There the texels on either side are up to
/// half a texel askew, most near the corners of the cube.
bool takes_two_faces(const glm::dvec3 &direction, int size);

/// Bilinear sample as a GPU takes it, across the edges of faces as well (seamless).
glm::dvec4 sample(const FigureField &field, const glm::dvec3 &direction);

/// The distance from the nearest line as a shader reads it, radians.
double sampled_distance(const FigureField &field, const glm::dvec3 &direction);

} // namespace blackhole
