// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/math.hpp"

namespace godot {

// A plane vector of whole numbers.
struct Vector2i {
	std::int32_t x = 0;
	std::int32_t y = 0;

	constexpr Vector2i() = default;
	constexpr Vector2i(std::int32_t p_x, std::int32_t p_y) : x(p_x), y(p_y) {}

	constexpr const std::int32_t &operator[](int axis) const { return axis == 0 ? x : y; }
	constexpr std::int32_t &operator[](int axis) { return axis == 0 ? x : y; }

	constexpr Vector2i operator-() const { return {-x, -y}; }
	constexpr Vector2i operator+(const Vector2i &v) const { return {x + v.x, y + v.y}; }
	constexpr Vector2i operator-(const Vector2i &v) const { return {x - v.x, y - v.y}; }
	constexpr Vector2i operator*(const Vector2i &v) const { return {x * v.x, y * v.y}; }
	constexpr Vector2i operator/(const Vector2i &v) const { return {x / v.x, y / v.y}; }
	constexpr Vector2i operator*(std::int32_t factor) const { return {x * factor, y * factor}; }
	constexpr Vector2i operator/(std::int32_t factor) const { return {x / factor, y / factor}; }
	constexpr Vector2i &operator+=(const Vector2i &v) { return *this = *this + v; }
	constexpr Vector2i &operator-=(const Vector2i &v) { return *this = *this - v; }
	constexpr Vector2i &operator*=(std::int32_t v) { return *this = *this * v; }
	constexpr Vector2i &operator/=(std::int32_t v) { return *this = *this / v; }
	constexpr bool operator==(const Vector2i &v) const = default;
	constexpr bool operator<(const Vector2i &v) const { return x < v.x || (x == v.x && (y < v.y)); }
};

constexpr Vector2i operator*(std::int32_t factor, const Vector2i &v) {
	return v * factor;
}

} // namespace godot
