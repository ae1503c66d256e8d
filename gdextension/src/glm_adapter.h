// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <godot_cpp/variant/vector3.hpp>

/// The one place where core's vectors and the engine's meet.
inline glm::dvec3 to_glm(const godot::Vector3 &v) {
	return {v.x, v.y, v.z};
}

inline godot::Vector3 to_godot(const glm::dvec3 &v) {
	return {static_cast<godot::real_t>(v.x), static_cast<godot::real_t>(v.y),
			static_cast<godot::real_t>(v.z)};
}
