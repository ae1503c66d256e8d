// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/math.hpp"

namespace godot {

// A vector of four components.
struct Vector4 {
	real_t x = 0.0F;
	real_t y = 0.0F;
	real_t z = 0.0F;
	real_t w = 0.0F;

	constexpr Vector4() = default;
	constexpr Vector4(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	constexpr const real_t &operator[](int axis) const {
		return axis == 0 ? x : (axis == 1 ? y : (axis == 2 ? z : w));
	}
	constexpr real_t &operator[](int axis) { return axis == 0 ? x : (axis == 1 ? y : (axis == 2 ? z : w)); }

	constexpr Vector4 operator-() const { return {-x, -y, -z, -w}; }
	constexpr Vector4 operator+(const Vector4 &v) const { return {x + v.x, y + v.y, z + v.z, w + v.w}; }
	constexpr Vector4 operator-(const Vector4 &v) const { return {x - v.x, y - v.y, z - v.z, w - v.w}; }
	constexpr Vector4 operator*(const Vector4 &v) const { return {x * v.x, y * v.y, z * v.z, w * v.w}; }
	constexpr Vector4 operator/(const Vector4 &v) const { return {x / v.x, y / v.y, z / v.z, w / v.w}; }
	constexpr Vector4 operator*(real_t factor) const {
		return {x * factor, y * factor, z * factor, w * factor};
	}
	constexpr Vector4 operator/(real_t factor) const {
		return {x / factor, y / factor, z / factor, w / factor};
	}
	constexpr Vector4 &operator+=(const Vector4 &v) { return *this = *this + v; }
	constexpr Vector4 &operator-=(const Vector4 &v) { return *this = *this - v; }
	constexpr Vector4 &operator*=(real_t v) { return *this = *this * v; }
	constexpr Vector4 &operator/=(real_t v) { return *this = *this / v; }
	constexpr bool operator==(const Vector4 &v) const = default;
	constexpr bool operator<(const Vector4 &v) const {
		return x < v.x || (x == v.x && (y < v.y || (y == v.y && (z < v.z || (z == v.z && (w < v.w))))));
	}

	constexpr real_t dot(const Vector4 &v) const { return x * v.x + y * v.y + z * v.z + w * v.w; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return Math::sqrt(length_squared()); }
	real_t distance_to(const Vector4 &v) const { return (v - *this).length(); }
	Vector4 normalized() const {
		const real_t size = length();
		return size == 0.0F ? Vector4() : *this / size;
	}
	bool is_finite() const {
		return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z) && Math::is_finite(w);
	}
	bool is_equal_approx(const Vector4 &v) const {
		return Math::is_equal_approx(x, v.x) && Math::is_equal_approx(y, v.y) &&
				Math::is_equal_approx(z, v.z) && Math::is_equal_approx(w, v.w);
	}
	bool is_zero_approx() const {
		return Math::is_zero_approx(x) && Math::is_zero_approx(y) && Math::is_zero_approx(z) &&
				Math::is_zero_approx(w);
	}
};

constexpr Vector4 operator*(real_t factor, const Vector4 &v) {
	return v * factor;
}

} // namespace godot
