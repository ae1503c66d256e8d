// SPDX-License-Identifier: MIT
#include "src/eye_tracker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/reflection_probe.hpp>
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
	// A frustum may look past its axis.
	const double wide = (1.0 + std::abs(projection.columns[2][0])) / scale_x;
	const double high = (1.0 + std::abs(projection.columns[2][1])) / scale_y;
	const double corner2 = 1.0 + wide * wide + high * high;
	eye.axis = -to_glm(camera->get_camera_transform().basis.get_column(2));
	eye.axis_gain = focal2 / (kReferenceFocal * kReferenceFocal);
	eye.corner_cosine = 1.0 / std::sqrt(corner2);
	// Parallel rays are shown as through another lens (view_ray.gdshaderinc).
	eye.everywhere = projection.columns[2][3] == 0.0F;
	return eye;
}

void add_once(std::vector<uint64_t> &ids, uint64_t id) {
	if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
		ids.push_back(id);
	}
}

} // namespace

PixelGain WatchingEye::pixel_gain(const glm::dvec3 &towards) const {
	PixelGain gain;
	gain.axis_gain = axis_gain;
	gain.corner_cosine = corner_cosine;
	gain.everywhere = everywhere;
	if (axis != glm::dvec3(0.0)) {
		gain.angle = std::acos(std::clamp(glm::dot(axis, towards), -1.0, 1.0));
	}
	return gain;
}

double WatchingEye::pixel_angle() const {
	return 1.0 / (kReferenceFocal * std::sqrt(axis_gain));
}

bool PixelGain::shows(double from, double to) const {
	if (angle < 0.0 || everywhere) {
		return true;
	}
	const double corner = std::acos(corner_cosine);
	return from <= angle + corner && to >= angle - corner;
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
	if (Object::cast_to<Viewport>(node) != nullptr) {
		add_once(viewports, node->get_instance_id());
	} else if (Object::cast_to<ReflectionProbe>(node) != nullptr) {
		add_once(probes, node->get_instance_id());
	}
}

void EyeTracker::remove(Node *node) {
	if (Object::cast_to<Viewport>(node) != nullptr) {
		std::erase(viewports, node->get_instance_id());
	} else if (Object::cast_to<ReflectionProbe>(node) != nullptr) {
		std::erase(probes, node->get_instance_id());
	}
}

void EyeTracker::clear() {
	viewports.clear();
	probes.clear();
}

/// Whether a reflection probe of the world sees any of the layers.
bool EyeTracker::is_mirrored(const Ref<World3D> &world, uint32_t layers) const {
	return std::any_of(probes.begin(), probes.end(), [&world, layers](uint64_t id) {
		const auto *probe = Object::cast_to<ReflectionProbe>(ObjectDB::get_instance(id));
		return probe != nullptr && probe->is_visible_in_tree() && (probe->get_cull_mask() & layers) != 0 &&
				probe->get_world_3d() == world;
	});
}

const std::vector<WatchingEye> &EyeTracker::eyes_in(const Ref<World3D> &world, uint32_t layers) {
	eyes.clear();
	const bool mirrored = is_mirrored(world, layers);
	for (const uint64_t id : viewports) {
		auto *viewport = Object::cast_to<Viewport>(ObjectDB::get_instance(id));
		if (viewport == nullptr || !viewport->is_inside_tree()) {
			continue;
		}
		const Camera3D *camera = viewport->get_camera_3d();
		if (camera != nullptr && (camera->get_cull_mask() & layers) != 0 &&
				viewport->find_world_3d() == world) {
			eyes.push_back(watching_eye(viewport, camera));
			eyes.back().everywhere = eyes.back().everywhere || mirrored;
		}
	}
	return eyes;
}
