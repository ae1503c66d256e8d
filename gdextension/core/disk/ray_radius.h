// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// u = r_s/r of the place that light from infinity reaches after the orbital angle eta [rad], 0 < eta, on its
/// way in; a = 1/b [1/r_s] is its inverse impact parameter and epsilon = a_c^2 - a^2, given apart so that it
/// keeps its relative precision near the critical ray. NaN beyond the turning point (a < a_c) or beyond
/// u = deepest (a > a_c). Absolute error about 1e-14 for u; the inverse of orbital_angle(), by bracketing.
double inverse_radius_on_ray(double a, double epsilon, double eta, double deepest);

} // namespace blackhole
