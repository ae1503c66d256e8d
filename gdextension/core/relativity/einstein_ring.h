// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/image_direction.h"

namespace blackhole {

/// The n-th Einstein ring (n >= 1): the rays with Phi = n pi. Odd n: of a star behind the hole; even n: of a
/// star behind the observer. Its angular radius is view_angle(u, ring.y, kappa).
ImageDirection einstein_ring(double u, int n);

} // namespace blackhole
