// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"
#include "core/relativity/observer_field.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// The plane in which light from a direction travels to an observer.
struct SkyFrame {
	double u = 0.0;
	/// Of the radially moving frame; the observer has the celerity relative to it.
	double kappa = 0.0;
	glm::dvec3 celerity{0.0};
	/// Unit vector from the hole to the observer.
	glm::dvec3 outward{0.0};
	/// Unit vector across `outward`, on the direction's side (any one where the direction is along the axis).
	glm::dvec3 azimuth{0.0};
	/// |outward - direction| and |outward + direction|: twice the sine and cosine of half the angle between
	/// them, which keep their precision at both ends.
	double near = 0.0;
	double far = 0.0;
};

/// The frame of `direction` (any length but zero), which is a direction at infinity or one in the radially
/// moving frame, for an observer.
Outcome<SkyFrame> sky_frame(const LocalObserver &at, glm::dvec3 direction);

/// A viewing direction of an observer, in the radially moving frame.
struct ViewFrame {
	SkyFrame at;
	/// Of the observer's boost, for light that is seen in that direction: nu_observed over nu in the radially
	/// moving frame.
	double doppler = 1.0;
};

/// The frame of `view_direction` (the observer's own frame, any length but zero) at position_rs (from the
/// hole, r_s). Fails where the motion does not exist.
Outcome<ViewFrame> view_frame(
		glm::dvec3 position_rs, glm::dvec3 view_direction, const ObserverField &observer);

} // namespace blackhole
