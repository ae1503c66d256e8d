// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/defs.hpp"

#include <cmath>
#include <concepts>
#include <numbers>

namespace godot {

inline constexpr double CMP_EPSILON = 0.00001;

namespace Math {

inline constexpr double PI = std::numbers::pi;
inline constexpr double TAU = 2.0 * std::numbers::pi;

template <std::floating_point T>
T sqrt(T value) {
	return std::sqrt(value);
}
template <std::floating_point T>
T abs(T value) {
	return std::abs(value);
}
template <std::floating_point T>
T lerp(T from, T to, T weight) {
	return from + (to - from) * weight;
}
template <std::floating_point T>
T deg_to_rad(T degrees) {
	return degrees * static_cast<T>(PI / 180.0);
}
template <std::floating_point T>
T rad_to_deg(T radians) {
	return radians * static_cast<T>(180.0 / PI);
}
template <std::floating_point T>
bool is_finite(T value) {
	return std::isfinite(value);
}
template <std::floating_point T>
bool is_nan(T value) {
	return std::isnan(value);
}

// Equal up to a relative error of CMP_EPSILON (an absolute one below 1).
template <std::floating_point T>
bool is_equal_approx(T left, T right) {
	if (left == right) {
		return true;
	}
	const T tolerance = static_cast<T>(CMP_EPSILON) * std::max(std::abs(left), T(1));
	return std::abs(left - right) < tolerance;
}
template <std::floating_point T>
bool is_zero_approx(T value) {
	return std::abs(value) < static_cast<T>(CMP_EPSILON);
}

} // namespace Math
} // namespace godot
