// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/math.hpp"

namespace godot {

// A plane vector.
struct Vector2 {
	real_t x = 0.0F;
	real_t y = 0.0F;

	constexpr Vector2() = default;
	constexpr Vector2(real_t p_x, real_t p_y) : x(p_x), y(p_y) {}

	constexpr const real_t &operator[](int axis) const { return axis == 0 ? x : y; }
	constexpr real_t &operator[](int axis) { return axis == 0 ? x : y; }

	constexpr Vector2 operator-() const { return {-x, -y}; }
	constexpr Vector2 operator+(const Vector2 &v) const { return {x + v.x, y + v.y}; }
	constexpr Vector2 operator-(const Vector2 &v) const { return {x - v.x, y - v.y}; }
	constexpr Vector2 operator*(const Vector2 &v) const { return {x * v.x, y * v.y}; }
	constexpr Vector2 operator/(const Vector2 &v) const { return {x / v.x, y / v.y}; }
	constexpr Vector2 operator*(real_t factor) const { return {x * factor, y * factor}; }
	constexpr Vector2 operator/(real_t factor) const { return {x / factor, y / factor}; }
	constexpr Vector2 &operator+=(const Vector2 &v) { return *this = *this + v; }
	constexpr Vector2 &operator-=(const Vector2 &v) { return *this = *this - v; }
	constexpr Vector2 &operator*=(real_t v) { return *this = *this * v; }
	constexpr Vector2 &operator/=(real_t v) { return *this = *this / v; }
	constexpr bool operator==(const Vector2 &v) const = default;
	constexpr bool operator<(const Vector2 &v) const { return x < v.x || (x == v.x && (y < v.y)); }

	constexpr real_t dot(const Vector2 &v) const { return x * v.x + y * v.y; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return Math::sqrt(length_squared()); }
	real_t distance_to(const Vector2 &v) const { return (v - *this).length(); }
	Vector2 normalized() const {
		const real_t size = length();
		return size == 0.0F ? Vector2() : *this / size;
	}
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y); }
	bool is_equal_approx(const Vector2 &v) const {
		return Math::is_equal_approx(x, v.x) && Math::is_equal_approx(y, v.y);
	}
	bool is_zero_approx() const { return Math::is_zero_approx(x) && Math::is_zero_approx(y); }
};

constexpr Vector2 operator*(real_t factor, const Vector2 &v) {
	return v * factor;
}

} // namespace godot
