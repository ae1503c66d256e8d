// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/math.hpp"

namespace godot {

// A space vector of whole numbers.
struct Vector3i {
	std::int32_t x = 0;
	std::int32_t y = 0;
	std::int32_t z = 0;

	constexpr Vector3i() = default;
	constexpr Vector3i(std::int32_t p_x, std::int32_t p_y, std::int32_t p_z) : x(p_x), y(p_y), z(p_z) {}

	constexpr const std::int32_t &operator[](int axis) const { return axis == 0 ? x : (axis == 1 ? y : z); }
	constexpr std::int32_t &operator[](int axis) { return axis == 0 ? x : (axis == 1 ? y : z); }

	constexpr Vector3i operator-() const { return {-x, -y, -z}; }
	constexpr Vector3i operator+(const Vector3i &v) const { return {x + v.x, y + v.y, z + v.z}; }
	constexpr Vector3i operator-(const Vector3i &v) const { return {x - v.x, y - v.y, z - v.z}; }
	constexpr Vector3i operator*(const Vector3i &v) const { return {x * v.x, y * v.y, z * v.z}; }
	constexpr Vector3i operator/(const Vector3i &v) const { return {x / v.x, y / v.y, z / v.z}; }
	constexpr Vector3i operator*(std::int32_t factor) const { return {x * factor, y * factor, z * factor}; }
	constexpr Vector3i operator/(std::int32_t factor) const { return {x / factor, y / factor, z / factor}; }
	constexpr Vector3i &operator+=(const Vector3i &v) { return *this = *this + v; }
	constexpr Vector3i &operator-=(const Vector3i &v) { return *this = *this - v; }
	constexpr Vector3i &operator*=(std::int32_t v) { return *this = *this * v; }
	constexpr Vector3i &operator/=(std::int32_t v) { return *this = *this / v; }
	constexpr bool operator==(const Vector3i &v) const = default;
	constexpr bool operator<(const Vector3i &v) const {
		return x < v.x || (x == v.x && (y < v.y || (y == v.y && (z < v.z))));
	}
};

constexpr Vector3i operator*(std::int32_t factor, const Vector3i &v) {
	return v * factor;
}

} // namespace godot
