// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/math.hpp"

namespace godot {

// A colour: red, green, blue, opacity; opaque black by default.
struct Color {
	float r = 0.0F;
	float g = 0.0F;
	float b = 0.0F;
	float a = 1.0F;

	constexpr Color() = default;
	constexpr Color(float p_r, float p_g, float p_b, float p_a = 1.0F) : r(p_r), g(p_g), b(p_b), a(p_a) {}
	constexpr Color(const Color &c, float p_a) : r(c.r), g(c.g), b(c.b), a(p_a) {}

	constexpr Color operator*(float factor) const { return {r * factor, g * factor, b * factor, a * factor}; }
	constexpr Color operator+(const Color &c) const { return {r + c.r, g + c.g, b + c.b, a + c.a}; }
	constexpr bool operator==(const Color &c) const = default;
	bool is_equal_approx(const Color &c) const {
		return Math::is_equal_approx(r, c.r) && Math::is_equal_approx(g, c.g) &&
				Math::is_equal_approx(b, c.b) && Math::is_equal_approx(a, c.a);
	}
};

} // namespace godot
