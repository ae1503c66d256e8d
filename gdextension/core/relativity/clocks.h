// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// The rate at which an observer SEES clocks at rest far away tick, per tick of the own clock, in the
/// direction view_direction: g = nu_observed/nu_infinity of that light. Below 1 is slow motion. The observer
/// is at position_rs (from the hole, r_s) with a celerity relative to the rain frame; the direction is in the
/// own axes (world axes carried by the boost). Relative error 1e-13. Fails in the shadow's directions, where
/// nothing far is seen, and for what is no place or direction.
Outcome<double> far_clock_rate(glm::dvec3 position_rs, glm::dvec3 celerity, glm::dvec3 view_direction);

/// The same for the light that falls in straight along the radius: 1/(1 + sqrt(u)) for rain,
/// 1/(eps + sqrt(eps^2 - 1 + u)) for radial infall, 1/sqrt(1 - u) for static observers.
Outcome<double> far_clock_rate_outward(glm::dvec3 position_rs, glm::dvec3 celerity);

} // namespace blackhole
