// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace blackhole {

/// What functions return where there is no answer.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

} // namespace blackhole
