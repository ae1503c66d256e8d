// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/core/object_id.hpp>

/// Knows every viewport of the scene tree, and so from where a world is being looked at in this frame.
class EyeTracker {
public:
	/// Collects the viewports below a node, itself included.
	void scan(godot::Node *root);
	void add(godot::Node *node);
	void remove(godot::Node *node);
	void clear() { viewports.clear(); }

	/// Places of all current cameras of `world`, world coordinates. The vector is reused: no allocation once
	/// it has its size.
	const std::vector<glm::dvec3> &eyes_in(const godot::Ref<godot::World3D> &world);

private:
	std::vector<godot::ObjectID> viewports;
	std::vector<glm::dvec3> eyes;
};
