// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"
#include "core/relativity/observer_field.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// One image of a star at infinity.
struct StarImage {
	/// Unit direction towards the image in the observer's own frame (world axes carried by the one boost).
	glm::dvec3 direction{0.0};
	/// Angle [rad] of the image from the direction to the hole, in the radially moving frame (for static,
	/// rain and infall the observer's own; for others rain).
	double xi = 0.0;
	/// Orbital angle Phi [rad] of the light.
	double orbital_angle = 0.0;
	/// Solid angle of the image over the star's without the hole, in the observer's frame; infinite on a
	/// caustic.
	double magnification = 0.0;
	/// g = nu_observed/nu_infinity.
	double redshift = 1.0;
};

/// The largest image order star_image() takes (Phi = 61 pi: its distance from the shadow is below any use).
inline constexpr int kMaxImageOrder = 60;

/// The exact image of the given order (0: direct, 1: round the other side, ...) of a star in direction
/// star_direction (world axes, any length), seen from position_rs (from the hole, r_s). A star exactly on the
/// axis has a whole ring of images: one point of the ring is returned. Fails with a reason where the motion
/// does not exist and for senseless arguments.
Outcome<StarImage> star_image(
		glm::dvec3 position_rs, glm::dvec3 star_direction, int order, const ObserverField &observer);

} // namespace blackhole
