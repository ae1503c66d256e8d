// SPDX-License-Identifier: MIT
#include "src/eye_tracker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/sub_viewport.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/core/object.hpp>

#include "src/glm_adapter.h"

using namespace godot;

namespace {

// The radiometric scale's reference pixel: 60 degrees of field over 720 rows.
constexpr double kReferenceFocal = 623.538290724796;
// Half the distance of two eyes, with a reserve, in metres: a headset's camera stands between them.
constexpr double kHeadsetWobble = 0.1;
// A headset's own projection is unknown here; none has a finer picture than this.
constexpr double kHeadsetGain = 16.0;

Vector2i size_of(Viewport *viewport) {
	if (const Window *window = Object::cast_to<Window>(viewport)) {
		return window->get_size();
	}
	const SubViewport *sub_viewport = Object::cast_to<SubViewport>(viewport);
	return sub_viewport != nullptr ? sub_viewport->get_size() : Vector2i(1920, 1080);
}

WatchingEye watching_eye(Viewport *viewport, const Camera3D *camera) {
	WatchingEye eye;
	eye.place = to_glm(camera->get_camera_transform().origin);
	eye.viewport = viewport->get_instance_id();
	eye.camera = camera->get_instance_id();
	if (viewport->is_using_xr()) {
		eye.axis_gain = kHeadsetGain;
		eye.wobble = kHeadsetWobble;
		return eye;
	}
	const Projection projection = camera->get_camera_projection();
	const Vector2i size = size_of(viewport);
	const double scale_x = projection.columns[0][0];
	const double scale_y = projection.columns[1][1];
	const double focal2 = 0.25 * scale_x * size.x * scale_y * size.y;
	const double corner2 = 1.0 + 1.0 / (scale_x * scale_x) + 1.0 / (scale_y * scale_y);
	eye.axis = -to_glm(camera->get_camera_transform().basis.get_column(2));
	eye.axis_gain = focal2 / (kReferenceFocal * kReferenceFocal);
	eye.corner_cosine = 1.0 / std::sqrt(corner2);
	return eye;
}

} // namespace

PixelGain WatchingEye::pixel_gain(const glm::dvec3 &towards) const {
	PixelGain gain;
	gain.axis_gain = axis_gain;
	gain.corner_cosine = corner_cosine;
	if (axis != glm::dvec3(0.0)) {
		gain.angle = std::acos(std::clamp(glm::dot(axis, towards), -1.0, 1.0));
	}
	return gain;
}

double PixelGain::operator()(double reach) const {
	if (angle < 0.0) {
		return axis_gain;
	}
	const double cosine = std::max(std::cos(std::min(angle + reach, std::numbers::pi)), corner_cosine);
	return axis_gain / (cosine * cosine * cosine);
}

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
	const uint64_t id = node->get_instance_id();
	if (std::find(viewports.begin(), viewports.end(), id) == viewports.end()) {
		viewports.push_back(id);
	}
}

void EyeTracker::remove(Node *node) {
	if (Object::cast_to<Viewport>(node) != nullptr) {
		std::erase(viewports, node->get_instance_id());
	}
}

const std::vector<WatchingEye> &EyeTracker::eyes_in(const Ref<World3D> &world, uint32_t layers) {
	eyes.clear();
	for (const uint64_t id : viewports) {
		auto *viewport = Object::cast_to<Viewport>(ObjectDB::get_instance(id));
		if (viewport == nullptr || !viewport->is_inside_tree()) {
			continue;
		}
		const Camera3D *camera = viewport->get_camera_3d();
		if (camera != nullptr && (camera->get_cull_mask() & layers) != 0 &&
				viewport->find_world_3d() == world) {
			eyes.push_back(watching_eye(viewport, camera));
		}
	}
	return eyes;
}
