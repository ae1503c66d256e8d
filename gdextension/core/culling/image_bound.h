// SPDX-License-Identifier: MIT
#pragma once

#include "core/culling/star_groups.h"
#include "core/photometry/planck_table.h"
#include "core/relativity/observer.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// What the bound needs of one eye; worked out once per eye and frame.
struct EyeBound {
	glm::dvec3 outward{0.0}; ///< unit vector from the hole to the eye, in the axes of the star groups
	double u = 0.0;     ///< r_s/r
	double kappa = 0.0; ///< of the observer's motion
	double sigma_c = 0.0;
	double w = 0.0; ///< edge scale of the tables' variable S0
	bool is_static = false;
};

/// position: of the eye from the hole in r_s, in the axes of the star groups, not zero. A static observer at
/// or inside the horizon counts as rain, as in the shader.
EyeBound eye_bound(const glm::dvec3 &position, ObserverMotion motion);

/// An upper bound of the brightness that the image of order `order` (0..3) of any star of the group can have
/// for this eye, as a V magnitude; -infinity where a star may lie on the caustic. Its use: a group whose
/// bound is fainter than the picture shows need not be drawn. Generous by about two magnitudes for the higher
/// orders, never short (tested against the exact images). `slack` (rad) widens the group, for eyes that move
/// a little.
double brightest_image_magnitude(
		const EyeBound &eye, const StarGroup &group, int order, double slack, const PlanckTable &planck);

} // namespace blackhole
