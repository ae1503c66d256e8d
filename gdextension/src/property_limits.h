// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

/// A new value of a property within its limits; what is no number leaves it as it was.
inline double limited(double value, double low, double high, double present) {
	return std::isnan(value) ? present : std::clamp(value, low, high);
}
