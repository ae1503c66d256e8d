// SPDX-License-Identifier: MIT
#include "src/background_layer.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

using namespace godot;

namespace {

constexpr int kRenderPriority = -110; // drawn first of all that is transparent
constexpr float kEverywhere = 1e6F;

/// One triangle that covers the picture, in clip coordinates.
RID make_screen_mesh(RenderingServer *server) {
	PackedVector3Array vertices;
	vertices.push_back(Vector3(-1, -1, 0));
	vertices.push_back(Vector3(3, -1, 0));
	vertices.push_back(Vector3(-1, 3, 0));
	Array arrays;
	arrays.resize(RenderingServer::ARRAY_MAX);
	arrays[RenderingServer::ARRAY_VERTEX] = vertices;
	RID mesh = server->mesh_create();
	server->mesh_add_surface_from_arrays(mesh, RenderingServer::PRIMITIVE_TRIANGLES, arrays);
	return mesh;
}

/// The Compatibility renderer does not decode sRGB textures; the others do by the texture's format.
bool arrives_as_srgb(RenderingServer *server, const RID &texture) {
	if (server->get_current_rendering_method() != "gl_compatibility") {
		return false;
	}
	switch (server->texture_get_format(texture)) {
		case Image::FORMAT_RF:
		case Image::FORMAT_RGF:
		case Image::FORMAT_RGBF:
		case Image::FORMAT_RGBAF:
		case Image::FORMAT_RH:
		case Image::FORMAT_RGH:
		case Image::FORMAT_RGBH:
		case Image::FORMAT_RGBAH:
		case Image::FORMAT_RGBE9995:
		case Image::FORMAT_BPTC_RGBF:
		case Image::FORMAT_BPTC_RGBFU:
		case Image::FORMAT_ASTC_4x4_HDR:
		case Image::FORMAT_ASTC_8x8_HDR:
			return false;
		default:
			return true;
	}
}

} // namespace

void BackgroundLayer::ensure() {
	if (instance.is_valid()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	lensed_shader = ResourceLoader::get_singleton()->load(
			"res://addons/blackhole_sky/shaders/background_lensed.gdshader");
	general_shader = ResourceLoader::get_singleton()->load(
			"res://addons/blackhole_sky/shaders/background_general.gdshader");
	map_shader = ResourceLoader::get_singleton()->load(
			"res://addons/blackhole_sky/shaders/background_map.gdshader");
	flat_shader = ResourceLoader::get_singleton()->load(
			"res://addons/blackhole_sky/shaders/background_flat.gdshader");
	material = server->material_create();
	dressed = false;
	server->material_set_render_priority(material, kRenderPriority);
	server->material_set_param(material, "_panorama_is_light", true);
	quad = make_screen_mesh(server);
	instance = server->instance_create();
	server->instance_set_base(instance, quad);
	server->instance_set_custom_aabb(instance,
			AABB(Vector3(-kEverywhere, -kEverywhere, -kEverywhere), Vector3(2, 2, 2) * kEverywhere));
	server->instance_geometry_set_material_override(instance, material);
	server->instance_geometry_set_cast_shadows_setting(instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
	if (scenario.is_valid()) {
		server->instance_set_scenario(instance, scenario);
	}
	show();
}

void BackgroundLayer::clear() {
	RenderingServer *server = RenderingServer::get_singleton();
	if (server == nullptr || !instance.is_valid()) {
		return;
	}
	server->free_rid(instance);
	server->free_rid(quad);
	server->free_rid(material);
	instance = quad = material = RID();
}

void BackgroundLayer::show() {
	if (instance.is_valid()) {
		RenderingServer::get_singleton()->instance_set_visible(
				instance, layer_shown && (source != 0 || redshift_map || current.overlays != 0));
	}
}

void BackgroundLayer::set_shown(bool shown) {
	layer_shown = shown;
	show();
}

void BackgroundLayer::set_scenario(const RID &p_scenario) {
	scenario = p_scenario;
	ensure();
	RenderingServer::get_singleton()->instance_set_scenario(instance, scenario);
}

void BackgroundLayer::set_tables(
		const RID &forward_table, const RID &inverse_table, const RID &planck_table) {
	ensure();
	RenderingServer *server = RenderingServer::get_singleton();
	server->material_set_param(material, "_forward_table", forward_table);
	server->material_set_param(material, "_inverse_table", inverse_table);
	server->material_set_param(material, "_planck_table", planck_table);
}

void BackgroundLayer::set_figure_field(const RID &cube_map) {
	ensure();
	RenderingServer::get_singleton()->material_set_param(material, "_figure_field", cube_map);
}

void BackgroundLayer::set_panorama_is_light(bool is_light) {
	ensure();
	RenderingServer::get_singleton()->material_set_param(material, "_panorama_is_light", is_light);
}

void BackgroundLayer::set_redshift_map(bool shown) {
	ensure();
	redshift_map = shown;
	RenderingServer::get_singleton()->material_set_param(material, "_redshift_map", shown);
	show();
}

void BackgroundLayer::set_source(int kind, const RID &panorama, double luminance) {
	ensure();
	RenderingServer *server = RenderingServer::get_singleton();
	source = kind;
	panorama_luminance = luminance;
	server->material_set_param(material, "_background", kind);
	server->material_set_param(material, "_panorama", panorama);
	server->material_set_param(
			material, "_panorama_is_srgb", panorama.is_valid() && arrives_as_srgb(server, panorama));
	server->material_set_param(material, "_panorama_luminance", panorama_luminance * current.exposure);
	show();
}

RID BackgroundLayer::shader(SkyShaders needed) const {
	switch (needed) {
		case SkyShaders::kRadial:
			return lensed_shader->get_rid();
		case SkyShaders::kGeneral:
			return general_shader->get_rid();
		case SkyShaders::kMap:
			return map_shader->get_rid();
		default:
			return flat_shader->get_rid();
	}
}

void BackgroundLayer::apply(const SkySettings &settings) {
	ensure();
	RenderingServer *server = RenderingServer::get_singleton();
	if (!dressed || settings.shaders != current.shaders) {
		server->material_set_shader(material, shader(settings.shaders));
	}
	if (!dressed || !has_equal_uniforms(settings, current)) {
		set_sky_uniforms(material, settings);
	}
	if (!dressed || settings.overlays != current.overlays ||
			settings.overlay_width != current.overlay_width || settings.lensing != current.lensing) {
		server->material_set_param(material, "_overlays", settings.overlays);
		server->material_set_param(material, "_overlay_width", settings.overlay_width);
		server->material_set_param(material, "_has_hole", settings.lensing);
	}
	dressed = true;
	current = settings;
	show();
	server->material_set_param(material, "_panorama_luminance", panorama_luminance * settings.exposure);
	server->instance_set_layer_mask(instance, settings.render_layers);
}
