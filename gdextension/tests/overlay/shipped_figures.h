// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/overlay/sky_segment.h"

namespace blackhole {

/// The segments of addons/blackhole_sky/data/constellations.json; none when the file cannot be read.
std::vector<SkySegment> shipped_figures();

} // namespace blackhole
