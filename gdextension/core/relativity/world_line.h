// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// Where an observer is on the way through space-time. Lengths in r_s, times in r_s/c, world axes.
struct WorldLineState {
	/// From the hole, in the flat space of Painleve-Gullstrand coordinates.
	glm::dvec3 position{0.0};
	/// gamma beta relative to the rain frame.
	glm::dvec3 celerity{0.0};
	double proper_time = 0.0;
	/// Painleve-Gullstrand time.
	double rain_time = 0.0;
};

/// Energy per rest mass (of what is at rest at infinity: 1); constant in free fall.
double orbital_energy(const WorldLineState &state);

/// Angular momentum per rest mass, position x celerity [r_s c]; constant in free fall.
glm::dvec3 angular_momentum(const WorldLineState &state);

/// How an advance along a world line ended.
enum class WorldLineEnd {
	/// The whole time has passed.
	kOnTheWay,
	/// Stopped at the smallest radius, kWorldLineEnd; only time backwards leads on from there.
	kCentre,
	/// Stopped early: too many steps were needed, because the motion came too close to that of light.
	kTooFast,
	/// Time or thrust are no numbers; nothing has changed.
	kRefused,
};

/// The radius [r_s] at which world lines end: tides there are 1e6 times those at the horizon.
inline constexpr double kWorldLineEnd = 0.01;

/// A piloted observer: free fall, or a thrust chosen from moment to moment. Each step (Runge-Kutta-Fehlberg
/// 7(8) of Boost.Odeint) has an error of at most 1e-13, absolute plus relative; after 100 r_s/c that leaves
/// about 1e-10, more where the motion itself amplifies errors. Nothing is allocated while advancing.
class WorldLine {
public:
	/// Fails for a position that is no place or nearer than kWorldLineEnd, and for a celerity that is no
	/// number or beyond 1e6.
	static Outcome<WorldLine> start(glm::dvec3 position_rs, glm::dvec3 celerity);

	[[nodiscard]] const WorldLineState &state() const { return state_; }

	/// Follows the world line for the proper time `duration` (negative: back) under the constant proper
	/// acceleration `thrust` [c^2/r_s], which is in the observer's own axes: the world axes carried by the
	/// boost from the rain frame.
	WorldLineEnd advance(double duration, glm::dvec3 thrust);

private:
	explicit WorldLine(const WorldLineState &state) : state_(state) {}

	WorldLineState state_;
	/// Step that the error control last found right.
	double step_ = 0.01;
};

} // namespace blackhole
