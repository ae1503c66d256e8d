// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace blackhole::test {

/// When a radial geodesic came by a radius.
struct FallTimes {
	double proper_time = 0.0;
	double rain_time = 0.0;
};

/// A radial geodesic inward from `radius` with a celerity (outward, relative to rain), integrated in short
/// steps of its equations of motion in Painleve-Gullstrand coordinates: no closed form, no conserved energy.
/// The times at which it passes each of `stops` (descending, below `radius`). Relative error about 1e-14.
std::vector<FallTimes> integrate_fall(
		long double radius, long double celerity, const std::vector<double> &stops);

/// Celerity, relative to rain, of what is at rest at `radius` > 1.
long double celerity_of_rest(long double radius);

} // namespace blackhole::test
