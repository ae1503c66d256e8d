// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "core/outcome.h"
#include "core/overlay/sky_segment.h"

namespace blackhole {

inline constexpr int kFigureFieldSize = 512;
inline constexpr double kFigureFieldReach = 0.06;

/// A cube map from which lines on the sky are drawn sharp at any magnification. A texel in direction d holds
/// (p - d, |p - d|), p being the nearest point of any segment, both unit vectors. Across a line the vector
/// passes through zero linearly, so that bilinear sampling finds the line itself between two texels, which
/// the length alone would not. Where two lines are equally near, though, the vectors to them are opposed and
/// their mean is short as well: there the interpolated length is right. The distance from a line is hence
///     max(length(texel.xyz), texel.w - margin)
/// in radians; `margin` is what the interpolated length is above the distance on a line at most. Lines
/// closer together than about 2 margin blend.
struct FigureField {
	int size = 0;        ///< texels along the edge of a face
	double reach = 0.0;  ///< radians
	double margin = 0.0; ///< radians
	/// RGBA texels: 6 faces in the order of cube_map.h, each `size` rows from the top. Further than `reach`
	/// from every segment they are reach (d, 1): no shorter than any vector within, and at right angles to
	/// it, so that interpolation across the rim makes nothing near zero.
	std::vector<float> texels;
};

/// Computes the field on the calling thread. Unit vectors; arcs shorter than half a turn; `size` from 8 to
/// 4096, `reach` above 0 and up to 0.5 radians. `progress` gets the part done (0 to 1) now and then and may
/// return false to cancel; then, and for values out of range, there is an error instead.
Outcome<FigureField> bake_figure_field(const std::vector<SkySegment> &segments, int size = kFigureFieldSize,
		double reach = kFigureFieldReach, const std::function<bool(double)> &progress = {});

} // namespace blackhole
