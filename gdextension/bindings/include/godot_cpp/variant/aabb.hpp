// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/vector3.hpp"

namespace godot {

// An axis-aligned box.
struct AABB {
	Vector3 position;
	Vector3 size;

	constexpr AABB() = default;
	constexpr AABB(const Vector3 &p_position, const Vector3 &p_size) : position(p_position), size(p_size) {}

	constexpr Vector3 get_position() const { return position; }
	constexpr Vector3 get_size() const { return size; }
	constexpr Vector3 get_end() const { return position + size; }
	constexpr Vector3 get_center() const { return position + size * 0.5F; }
	constexpr bool has_point(const Vector3 &p) const {
		const Vector3 end = get_end();
		return p.x >= position.x && p.y >= position.y && p.z >= position.z && p.x <= end.x && p.y <= end.y &&
				p.z <= end.z;
	}
	constexpr bool operator==(const AABB &other) const = default;
};

} // namespace godot
