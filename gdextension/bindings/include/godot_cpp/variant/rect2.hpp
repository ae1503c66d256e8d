// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/vector2.hpp"

namespace godot {

// An axis-aligned rectangle.
struct Rect2 {
	Vector2 position;
	Vector2 size;

	constexpr Rect2() = default;
	constexpr Rect2(const Vector2 &p_position, const Vector2 &p_size) : position(p_position), size(p_size) {}
	constexpr Rect2(real_t x, real_t y, real_t width, real_t height) : position(x, y), size(width, height) {}

	constexpr Vector2 get_position() const { return position; }
	constexpr Vector2 get_size() const { return size; }
	constexpr Vector2 get_end() const { return position + size; }
	constexpr bool operator==(const Rect2 &other) const = default;
};

} // namespace godot
