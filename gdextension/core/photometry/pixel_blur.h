// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace blackhole {

/// A round pattern convolved with a Gaussian: the value at the radius p_r (>= 0), in light per unit area.
/// p_encircled(r): share of the pattern's light within r, rising from 0 to 1, smooth or stepped; p_sigma (>
/// 0): standard deviation of the Gaussian along one axis, in the same unit. Within 0.3 % for structures much
/// finer than p_sigma, far closer else.
double pixel_blurred(const std::function<double(double)> &p_encircled, double p_sigma, double p_r);

} // namespace blackhole
