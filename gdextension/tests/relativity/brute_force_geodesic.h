// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole::test {

/// A light ray followed backwards from the observer by integrating the orbit equation u'' = 3/2 u^2 - u step
/// by step (u = r_s/r over the orbital angle). Slow, and independent of every elliptic integral and of sigma.
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
