// SPDX-License-Identifier: MIT
#include "relativity/brute_force_geodesic.h"

#include <algorithm>
#include <cmath>

namespace blackhole::test {
namespace {

TracedRay trace(double u, double slope) {
	OrbitIntegrator orbit(u, slope);
	TracedRay ray;
	ray.largest_u = u;
	const double unbound = 1e3 * (1.0 + std::hypot(u, slope));
	while (ray.phi < 60.0 && orbit.u() < unbound) {
		const double to_infinity = orbit.slope() < 0.0 ? -orbit.u() / orbit.slope() : 1.0;
		const bool last = to_infinity < orbit.natural_step();
		// Onto u = 0 by Newton's method on the step, elsewhere a fixed part of the shortest scale.
		const double step = last ? to_infinity : orbit.natural_step();
		orbit.advance(step);
		ray.phi += step;
		ray.largest_u = std::max(ray.largest_u, orbit.u());
		if (last && std::abs(step) < 1e-15 * ray.phi) {
			ray.captured = false;
			break;
		}
	}
	return ray;
}

} // namespace

double OrbitIntegrator::natural_step() const {
	return 0.02 / std::sqrt(1.0 + state[0] + std::abs(state[1]));
}

void OrbitIntegrator::advance(double angle) {
	const auto orbit_equation = [](const State &at, State &change, double /*phi*/) {
		change = {at[1], 1.5 * at[0] * at[0] - at[0]};
	};
	stepper.do_step(orbit_equation, state, 0.0, angle); // the equation is the same at every angle
}

double slope_from_static(double u, double xi) {
	// dr/(r dphi) = -sqrt(1 - u) cot xi in the static frame
	return u * std::sqrt(1.0 - u) * std::cos(xi) / std::sin(xi);
}

double slope_from_rain(double u, double xi) {
	// The photon moves outward at cos xi in a frame that falls inward at sqrt(u).
	return u * (std::cos(xi) - std::sqrt(u)) / std::sin(xi);
}

TracedRay trace_from_static(double u, double xi) {
	return trace(u, slope_from_static(u, xi));
}

TracedRay trace_from_rain(double u, double xi) {
	return trace(u, slope_from_rain(u, xi));
}

} // namespace blackhole::test
