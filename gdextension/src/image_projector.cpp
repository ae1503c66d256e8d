// SPDX-License-Identifier: MIT
#include "src/image_projector.h"

#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/variant/projection.hpp>

#include "core/projection/sky_map.h"
#include "core/relativity/observer.h"
#include "core/tables/shader_lensing.h"
#include "src/glm_adapter.h"

using namespace godot;

namespace {

/// The direction in which the image is seen, world axes.
Vector3 seen_direction(const SkySettings &settings, const blackhole::LensingTables *tables,
		const Vector3 &eye, const Vector3 &star, int order) {
	if (tables == nullptr) {
		// Without a hole only a given velocity aberrates.
		const bool flies = settings.observer.motion == blackhole::ObserverMotion::kVelocity &&
				(settings.effects & lensing_shader::kAberration) != 0;
		return flies ? to_godot(blackhole::boost_direction(to_glm(star), settings.observer.celerity)) : star;
	}
	const glm::dvec3 place = place_in_radii(settings, to_glm(eye));
	const auto image = blackhole::ShaderLensing(*tables).star_image(
			glm::vec3(place), glm::vec3(to_glm(star)), order, settings.observer, 0.0F, settings.effects);
	return to_godot(glm::dvec3(image.direction));
}

} // namespace

std::optional<Vector2> project_image(const SkySettings &settings, const blackhole::LensingTables *tables,
		const Camera3D *camera, const Vector3 &direction, int order) {
	const Transform3D transform = camera->get_camera_transform();
	const Vector3 star = settings.sky_to_world.xform(direction.normalized());
	const Vector3 world = seen_direction(settings, tables, transform.origin, star, order);
	const Vector3 view = transform.basis.transposed().xform(world);
	const Vector2 picture = camera->get_viewport()->get_visible_rect().size;
	if (settings.projection != 0) {
		const auto pixel = blackhole::SkyMap(settings.projection)
								   .pixel(glm::vec3(to_glm(view)), glm::vec2(picture.x, picture.y));
		return pixel ? std::optional(Vector2(pixel->x, pixel->y)) : std::nullopt;
	}
	const Projection projection = camera->get_camera_projection();
	if (!(view.z < 0)) {
		return std::nullopt;
	}
	// Shifted frusta move the picture's middle.
	const real_t x = (projection.columns[0][0] * view.x + projection.columns[2][0] * view.z) / -view.z;
	const real_t y = (projection.columns[1][1] * view.y + projection.columns[2][1] * view.z) / -view.z;
	return Vector2((real_t(0.5) + real_t(0.5) * x) * picture.x, (real_t(0.5) - real_t(0.5) * y) * picture.y);
}
