// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"
#include "core/relativity/observer_field.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// Angular radius xi_c [rad] of the hole's shadow for an observer at u = r_s/r > 0; NaN where the motion does
/// not exist. Relative error 1e-15.
double shadow_half_angle(double u, ObserverMotion motion);

/// The hole's shadow as an observer sees it: a circle, since aberration makes circles of circles.
struct ApparentShadow {
	/// Unit direction towards its centre, in the observer's own frame.
	glm::dvec3 centre{0.0};
	/// Its angular radius [rad], 0 to pi.
	double half_angle = 0.0;
};

/// The shadow of any observer at position_rs (from the hole, r_s); fails where there is no such observer.
Outcome<ApparentShadow> apparent_shadow(glm::dvec3 position_rs, const ObserverField &observer);

/// Where a viewing direction ends.
struct SkyRay {
	/// The ray comes from the hole's shadow: no sky there, and the other fields mean nothing.
	bool captured = false;
	/// Unit direction (world axes) of the place on the sky at infinity that is seen.
	glm::dvec3 sky_direction{0.0};
	/// Orbital angle Phi of the ray [rad].
	double orbital_angle = 0.0;
	/// g = nu_observed/nu_infinity.
	double redshift = 1.0;
};

/// The exact forward mapping for an observer at position_rs (from the hole, r_s, world axes) who looks along
/// view_direction (in the observer's own frame, whose axes are the world axes carried by the one boost from
/// the rain frame). Fails where the motion does not exist and for directions without length.
Outcome<SkyRay> trace_view_direction(
		glm::dvec3 position_rs, glm::dvec3 view_direction, const ObserverField &observer);

} // namespace blackhole
