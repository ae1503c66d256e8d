// SPDX-License-Identifier: MIT
#pragma once

#include "core/tables/ray_tables.h"
#include "core/tables/ray_texels.h"

#include <functional>
#include <vector>

namespace blackhole {

/// The tables from which light round a Schwarzschild hole is drawn, for every observer at once. A texel
/// holds (value, d/dx, d/dv, d2/dx dv), the derivatives times the grid steps, for bicubic Hermite
/// interpolation; x is the column coordinate of table_axis.h, v = ln u the row coordinate. With w, S0 of
/// relativity/baseline.h: `inverse` (star -> direction): R = (sigma - sigma_c)/S0(Phi) over X =
/// ln(S0/sqrt(w/2)); `forward` (direction -> Phi): Q = S0(Phi)/(sigma - sigma_c) over X = ln((sigma -
/// sigma_c)/sqrt(w/2)).
struct LensingTables {
	int columns = 0;
	int rows = 0;
	double ln_u_min = 0.0;
	double ln_u_max = 0.0;
	double x_limit = 0.0;
	/// RGBA texels, row-major, row = u: 4 columns rows floats each.
	std::vector<float> inverse;
	std::vector<float> forward;
	/// What rays meet on their way, for disks.
	RayTables rays;
	/// And as the graphics device reads it.
	RayTexels ray_texels;
};

/// Computes all tables from the exact solution, on the calling thread. `progress` gets the part done (0 to
/// 1) now and then and may return false to cancel; then the result is empty (columns = 0).
LensingTables bake_lensing_tables(const std::function<bool(double)> &progress = {});

} // namespace blackhole
