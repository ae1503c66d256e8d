// SPDX-License-Identifier: MIT
#include "core/relativity/einstein_ring.h"

#include <numbers>

namespace blackhole {

ImageDirection einstein_ring(double u, int n) {
	return image_direction(u, n * std::numbers::pi);
}

} // namespace blackhole
