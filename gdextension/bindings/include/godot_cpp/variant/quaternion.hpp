// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/vector3.hpp"

namespace godot {

// A rotation as a unit quaternion.
struct Quaternion {
	real_t x = 0.0F;
	real_t y = 0.0F;
	real_t z = 0.0F;
	real_t w = 1.0F;

	constexpr Quaternion() = default;
	constexpr Quaternion(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}
	// The rotation by `angle` (radians) about a unit axis.
	Quaternion(const Vector3 &axis, real_t angle)
			: x(axis.x * std::sin(angle / 2.0F)), y(axis.y * std::sin(angle / 2.0F)),
			  z(axis.z * std::sin(angle / 2.0F)), w(std::cos(angle / 2.0F)) {}

	constexpr Quaternion operator*(const Quaternion &q) const {
		return {w * q.x + x * q.w + y * q.z - z * q.y, w * q.y + y * q.w + z * q.x - x * q.z,
				w * q.z + z * q.w + x * q.y - y * q.x, w * q.w - x * q.x - y * q.y - z * q.z};
	}
	constexpr Quaternion inverse() const { return {-x, -y, -z, w}; }
	constexpr Vector3 xform(const Vector3 &v) const {
		const Vector3 axis(x, y, z);
		return v + (axis.cross(v) * w + axis.cross(axis.cross(v))) * 2.0F;
	}
	constexpr bool operator==(const Quaternion &q) const = default;
};

} // namespace godot
