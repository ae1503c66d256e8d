// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/math.hpp"

namespace godot {

// A space vector.
struct Vector3 {
	real_t x = 0.0F;
	real_t y = 0.0F;
	real_t z = 0.0F;

	constexpr Vector3() = default;
	constexpr Vector3(real_t p_x, real_t p_y, real_t p_z) : x(p_x), y(p_y), z(p_z) {}

	constexpr const real_t &operator[](int axis) const { return axis == 0 ? x : (axis == 1 ? y : z); }
	constexpr real_t &operator[](int axis) { return axis == 0 ? x : (axis == 1 ? y : z); }

	constexpr Vector3 operator-() const { return {-x, -y, -z}; }
	constexpr Vector3 operator+(const Vector3 &v) const { return {x + v.x, y + v.y, z + v.z}; }
	constexpr Vector3 operator-(const Vector3 &v) const { return {x - v.x, y - v.y, z - v.z}; }
	constexpr Vector3 operator*(const Vector3 &v) const { return {x * v.x, y * v.y, z * v.z}; }
	constexpr Vector3 operator/(const Vector3 &v) const { return {x / v.x, y / v.y, z / v.z}; }
	constexpr Vector3 operator*(real_t factor) const { return {x * factor, y * factor, z * factor}; }
	constexpr Vector3 operator/(real_t factor) const { return {x / factor, y / factor, z / factor}; }
	constexpr Vector3 &operator+=(const Vector3 &v) { return *this = *this + v; }
	constexpr Vector3 &operator-=(const Vector3 &v) { return *this = *this - v; }
	constexpr Vector3 &operator*=(real_t v) { return *this = *this * v; }
	constexpr Vector3 &operator/=(real_t v) { return *this = *this / v; }
	constexpr bool operator==(const Vector3 &v) const = default;
	constexpr bool operator<(const Vector3 &v) const {
		return x < v.x || (x == v.x && (y < v.y || (y == v.y && (z < v.z))));
	}

	constexpr real_t dot(const Vector3 &v) const { return x * v.x + y * v.y + z * v.z; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return Math::sqrt(length_squared()); }
	real_t distance_to(const Vector3 &v) const { return (v - *this).length(); }
	Vector3 normalized() const {
		const real_t size = length();
		return size == 0.0F ? Vector3() : *this / size;
	}
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z); }
	bool is_equal_approx(const Vector3 &v) const {
		return Math::is_equal_approx(x, v.x) && Math::is_equal_approx(y, v.y) &&
				Math::is_equal_approx(z, v.z);
	}
	bool is_zero_approx() const {
		return Math::is_zero_approx(x) && Math::is_zero_approx(y) && Math::is_zero_approx(z);
	}
	constexpr Vector3 cross(const Vector3 &v) const {
		return {y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x};
	}
	real_t angle_to(const Vector3 &v) const { return std::atan2(cross(v).length(), dot(v)); }
};

constexpr Vector3 operator*(real_t factor, const Vector3 &v) {
	return v * factor;
}

} // namespace godot
