// SPDX-License-Identifier: MIT
#include "src/sky_settings.h"

#include <glm/geometric.hpp>

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/vector4.hpp>

#include "src/glm_adapter.h"

using namespace godot;

glm::dvec3 place_in_radii(const SkySettings &settings, const glm::dvec3 &place) {
	const glm::dvec3 from_hole = (place - to_glm(settings.hole_position)) * settings.inverse_radius;
	return glm::length(from_hole) > kNearestPlace ? from_hole : glm::dvec3(0.0, 0.0, kNearestPlace);
}

bool has_equal_uniforms(const SkySettings &a, const SkySettings &b) {
	return a.hole_position == b.hole_position && a.inverse_radius == b.inverse_radius &&
			a.observer == b.observer && a.effects == b.effects && a.projection == b.projection &&
			a.sky_to_world == b.sky_to_world && a.saturation == b.saturation &&
			a.stereo_baseline_scale == b.stereo_baseline_scale && a.see_through == b.see_through;
}

void set_sky_uniforms(const RID &material, const SkySettings &settings) {
	RenderingServer *server = RenderingServer::get_singleton();
	const lensing_shader::Motion motion = lensing_shader::motion_of(settings.observer);
	const glm::vec4 &given = motion.parameters;
	server->material_set_param(material, "_hole_position", settings.hole_position);
	server->material_set_param(material, "_inverse_radius", settings.inverse_radius);
	server->material_set_param(material, "_observer_motion", motion.code);
	server->material_set_param(material, "_observer_parameters", Vector4(given.x, given.y, given.z, given.w));
	server->material_set_param(material, "_effects", settings.effects);
	server->material_set_param(material, "_projection", settings.projection);
	server->material_set_param(material, "_sky_to_world", settings.sky_to_world);
	server->material_set_param(material, "_saturation", settings.saturation);
	server->material_set_param(material, "_stereo_baseline_scale", settings.stereo_baseline_scale);
	server->material_set_param(material, "_see_through", settings.see_through);
}
