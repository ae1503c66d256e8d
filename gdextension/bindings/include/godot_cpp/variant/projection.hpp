// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/vector4.hpp"

namespace godot {

// A 4x4 matrix stored by columns.
struct Projection {
	Vector4 columns[4] = {Vector4(1, 0, 0, 0), Vector4(0, 1, 0, 0), Vector4(0, 0, 1, 0), Vector4(0, 0, 0, 1)};

	constexpr const Vector4 &operator[](int column) const { return columns[column]; }
	constexpr Vector4 &operator[](int column) { return columns[column]; }
	constexpr Vector4 xform(const Vector4 &v) const {
		return columns[0] * v.x + columns[1] * v.y + columns[2] * v.z + columns[3] * v.w;
	}
	constexpr bool operator==(const Projection &other) const = default;
};

} // namespace godot
