// SPDX-License-Identifier: MIT
#include "relativity/brute_force_geodesic.h"

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace blackhole::test {
namespace {

namespace odeint = boost::numeric::odeint;

/// u and du/dphi.
using State = std::array<double, 2>;

void orbit_equation(const State &state, State &slope, double /*phi*/) {
	slope = {state[1], 1.5 * state[0] * state[0] - state[0]};
}

/// A short step in the angle, on which the eighth-order formula leaves about 1e-15 of the state.
double step_size(const State &state) {
	return 0.02 / std::sqrt(1.0 + state[0] + std::abs(state[1]));
}

TracedRay trace(State state) {
	odeint::runge_kutta_fehlberg78<State> stepper;
	TracedRay ray;
	ray.largest_u = state[0];
	const double unbound = 1e3 * (1.0 + std::hypot(state[0], state[1]));
	while (ray.phi < 60.0 && state[0] < unbound) {
		const double to_infinity = state[1] < 0.0 ? -state[0] / state[1] : 1.0;
		const bool last = to_infinity < step_size(state);
		// Onto u = 0 by Newton's method on the step, elsewhere a fixed part of the shortest scale.
		const double step = last ? to_infinity : step_size(state);
		stepper.do_step(orbit_equation, state, ray.phi, step);
		ray.phi += step;
		ray.largest_u = std::max(ray.largest_u, state[0]);
		if (last && std::abs(step) < 1e-15 * ray.phi) {
			ray.captured = false;
			break;
		}
	}
	return ray;
}

} // namespace

TracedRay trace_from_static(double u, double xi) {
	// dr/(r dphi) = -sqrt(1 - u) cot xi in the static frame
	return trace({u, u * std::sqrt(1.0 - u) * std::cos(xi) / std::sin(xi)});
}

TracedRay trace_from_rain(double u, double xi) {
	// The photon moves outward at cos xi in a frame that falls inward at sqrt(u).
	return trace({u, u * (std::cos(xi) - std::sqrt(u)) / std::sin(xi)});
}

} // namespace blackhole::test
