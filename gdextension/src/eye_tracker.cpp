// SPDX-License-Identifier: MIT
#include "src/eye_tracker.h"

#include <algorithm>

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/core/object.hpp>

#include "src/glm_adapter.h"

using namespace godot;

void EyeTracker::scan(Node *root) {
	add(root);
	for (int i = 0; i < root->get_child_count(true); ++i) {
		scan(root->get_child(i, true));
	}
}

void EyeTracker::add(Node *node) {
	if (Object::cast_to<Viewport>(node) == nullptr) {
		return;
	}
	const ObjectID id(node->get_instance_id());
	if (std::find(viewports.begin(), viewports.end(), id) == viewports.end()) {
		viewports.push_back(id);
	}
}

void EyeTracker::remove(Node *node) {
	if (Object::cast_to<Viewport>(node) != nullptr) {
		std::erase(viewports, ObjectID(node->get_instance_id()));
	}
}

const std::vector<glm::dvec3> &EyeTracker::eyes_in(const Ref<World3D> &world) {
	eyes.clear();
	for (const ObjectID id : viewports) {
		auto *viewport = Object::cast_to<Viewport>(ObjectDB::get_instance(id));
		if (viewport == nullptr || !viewport->is_inside_tree()) {
			continue;
		}
		const Camera3D *camera = viewport->get_camera_3d();
		if (camera != nullptr && viewport->find_world_3d() == world) {
			eyes.push_back(to_glm(camera->get_camera_transform().origin));
		}
	}
	return eyes;
}
