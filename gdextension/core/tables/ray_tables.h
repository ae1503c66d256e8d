// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

namespace blackhole {

/// What light meets on its way from infinity, for every impact parameter at once: rays of inverse impact
/// parameter a followed by the angle eta [rad] that they have swept since infinity, to a little beyond the
/// turning point or to r = r_s/20. A texel holds (value, d/d column, d/d row, both) for bicubic Hermite
/// interpolation on the grid of ray_axis.h.
///  radius: sqrt(a eta/u), u = r_s/r: smooth from straight light, 1, to the singularity, 0;
///  delay:  2 a V/eta, V [r_s/c] the advanced time (ingoing Eddington-Finkelstein) that the light has spent,
///          which is finite from infinity and regular at the horizon: dV/d eta = 1/(a + du/d eta).
struct RayTables {
	/// RGBA texels, row-major: 4 kRayColumns kRayRows floats each.
	std::vector<float> radius;
	std::vector<float> delay;
};

/// Computes both tables on the calling thread by integrating the orbit equation u'' = 3/2 u^2 - u and its
/// variation with the impact parameter, to 1e-12. `progress` gets the part done (0 to 1) and may return false
/// to cancel; then the result is empty.
RayTables bake_ray_tables(const std::function<bool(double)> &progress = {});

} // namespace blackhole
