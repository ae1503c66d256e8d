// SPDX-License-Identifier: MIT
#include "relativity/brute_force_fall.h"

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <array>
#include <cmath>

namespace blackhole::test {
namespace {

namespace odeint = boost::numeric::odeint;

/// Radius, celerity, proper time, PG time; the free variable is the arc x with dtau = 2 r dx, on which the
/// motion is smooth down to the centre.
using State = std::array<long double, 4>;
using Stepper = odeint::runge_kutta_fehlberg78<State, long double>;

void geodesic(const State &state, State &slope, long double /*x*/) {
	const long double r = state[0];
	const long double w = state[1];
	const long double gamma = std::sqrt(1.0L + w * w);
	const long double flow = 1.0L / std::sqrt(r);
	const long double pace = 2.0L * r;
	slope = {pace * (w - gamma * flow), -pace * 0.5L * gamma * w * flow / r, pace, pace * gamma};
}

} // namespace

std::vector<FallTimes> integrate_fall(
		long double radius, long double celerity, const std::vector<double> &stops) {
	Stepper stepper;
	State state = {radius, celerity, 0.0L, 0.0L};
	std::vector<FallTimes> times;
	for (const long double stop : stops) {
		while (std::abs(state[0] - stop) > 1e-17L * (1.0L + stop)) {
			State slope{};
			geodesic(state, slope, 0.0L);
			const long double step = 0.005L * std::sqrt(1.0L + state[0] * 0.1L) / std::hypot(1.0L, state[1]);
			// Newton's method onto the stop, once it is within a step.
			const long double there = (stop - state[0]) / slope[0];
			const bool last = std::abs(there) < step;
			stepper.do_step(geodesic, state, 0.0L, last ? there : step);
		}
		times.push_back({static_cast<double>(state[2]), static_cast<double>(state[3])});
	}
	return times;
}

long double celerity_of_rest(long double radius) {
	return 1.0L / std::sqrt(radius - 1.0L);
}

} // namespace blackhole::test
