// SPDX-License-Identifier: MIT
#pragma once

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <array>

namespace blackhole::test {

/// A light ray's u = r_s/r over the orbital angle, by integrating u'' = 3/2 u^2 - u. Slow, and independent of
/// every elliptic integral and of sigma.
class OrbitIntegrator {
public:
	/// From u with this du/dphi.
	OrbitIntegrator(double p_u, double p_slope) : state{p_u, p_slope} {}

	double u() const { return state[0]; }
	double slope() const { return state[1]; }
	/// A short step in the angle, on which the eighth-order formula leaves about 1e-15 of the state.
	double natural_step() const;
	void advance(double angle);

private:
	using State = std::array<double, 2>;
	boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
	State state;
};

/// du/dphi at u, followed backwards, of the ray that a static observer or rain sees at xi [rad] from the
/// hole.
double slope_from_static(double u, double xi);
double slope_from_rain(double u, double xi);

/// A light ray followed backwards from the observer to where it ends.
struct TracedRay {
	/// It fell in, or did not get away within 60 rad.
	bool captured = true;
	/// Orbital angle [rad] at which it reached infinity.
	double phi = 0.0;
	/// Largest u on the way.
	double largest_u = 0.0;
};

/// The ray that a static observer at u < 1 sees at the angle xi [rad] from the hole.
TracedRay trace_from_static(double u, double xi);

/// The same for an observer falling from rest at infinity, any u > 0.
TracedRay trace_from_rain(double u, double xi);

} // namespace blackhole::test
