// SPDX-License-Identifier: MIT
#include "src/background_layer.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/resource_loader.hpp>

#include "src/black_hole_sky.h"
#include "src/draw_order.h"
#include "src/empty_cubemap.h"

using namespace godot;

namespace {

/// The Compatibility renderer does not decode sRGB textures; the others do by the texture's format.
bool has_srgb_values(RenderingServer *server, const RID &texture) {
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

/// Whether the shader gets sRGB values of the picture that is shown.
bool arrives_as_srgb(RenderingServer *server, int kind, const BackgroundPictures &pictures) {
	if (server->get_current_rendering_method() != "gl_compatibility") {
		return false;
	}
	switch (kind) {
		case BlackHoleSky::BACKGROUND_PANORAMA:
			return pictures.panorama.is_valid() && has_srgb_values(server, pictures.panorama);
		case BlackHoleSky::BACKGROUND_CUBEMAP:
			return pictures.cubemap.is_valid() && has_srgb_values(server, pictures.cubemap);
		default: // what it draws itself is what the screen would show
			return kind == BlackHoleSky::BACKGROUND_SURROUNDINGS;
	}
}

} // namespace

void BackgroundLayer::ensure() {
	if (triangle.is_made()) {
		return;
	}
	lensed_shader = ResourceLoader::get_singleton()->load(
			"res://addons/blackhole_sky/shaders/background_lensed.gdshader");
	general_shader = ResourceLoader::get_singleton()->load(
			"res://addons/blackhole_sky/shaders/background_general.gdshader");
	map_shader = ResourceLoader::get_singleton()->load(
			"res://addons/blackhole_sky/shaders/background_map.gdshader");
	flat_shader = ResourceLoader::get_singleton()->load(
			"res://addons/blackhole_sky/shaders/background_flat.gdshader");
	triangle.make(kBackgroundPriority);
	dressed = false;
	triangle.set_parameter("_panorama_is_light", true);
	triangle.set_parameter("_figure_field", empty_cubemap());
	triangle.set_parameter("_cubemap", empty_cubemap());
	show();
}

void BackgroundLayer::show() {
	if (triangle.is_made()) {
		// Before a room the shadow is dark by itself.
		const bool shows = source != 0 || redshift_map || current.overlays != 0 || is_clear(current);
		triangle.set_visible(layer_shown && shows);
	}
}

void BackgroundLayer::set_shown(bool shown) {
	layer_shown = shown;
	show();
}

void BackgroundLayer::set_scenario(const RID &scenario) {
	ensure();
	triangle.set_scenario(scenario);
}

void BackgroundLayer::set_tables(
		const RID &forward_table, const RID &inverse_table, const RID &planck_table) {
	ensure();
	triangle.set_parameter("_forward_table", forward_table);
	triangle.set_parameter("_inverse_table", inverse_table);
	triangle.set_parameter("_planck_table", planck_table);
}

void BackgroundLayer::set_figure_field(const RID &cube_map) {
	ensure();
	triangle.set_parameter("_figure_field", cube_map.is_valid() ? cube_map : empty_cubemap());
}

void BackgroundLayer::set_panorama_is_light(bool is_light) {
	ensure();
	triangle.set_parameter("_panorama_is_light", is_light);
}

void BackgroundLayer::set_redshift_map(bool shown) {
	ensure();
	redshift_map = shown;
	triangle.set_parameter("_redshift_map", shown);
	show();
}

void BackgroundLayer::set_source(int kind, const BackgroundPictures &pictures, double luminance) {
	ensure();
	source = kind;
	panorama_luminance = luminance;
	triangle.set_parameter("_background", kind);
	triangle.set_parameter("_panorama", pictures.panorama);
	triangle.set_parameter("_cubemap", pictures.cubemap.is_valid() ? pictures.cubemap : empty_cubemap());
	triangle.set_parameter("_surroundings", pictures.surroundings);
	triangle.set_parameter(
			"_picture_is_srgb", arrives_as_srgb(RenderingServer::get_singleton(), kind, pictures));
	triangle.set_parameter("_panorama_luminance", panorama_luminance * current.exposure);
	show();
}

RID BackgroundLayer::shader(const SkySettings &settings) {
	if (is_clear(settings)) {
		const bool radial = settings.shaders == SkyShaders::kRadial;
		Ref<Shader> &clear = radial ? clear_lensed_shader : clear_general_shader;
		if (clear.is_null()) {
			clear = ResourceLoader::get_singleton()->load(radial
							? "res://addons/blackhole_sky/shaders/background_lensed_clear.gdshader"
							: "res://addons/blackhole_sky/shaders/background_general_clear.gdshader");
		}
		return clear->get_rid();
	}
	switch (settings.shaders) {
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
	if (!dressed || settings.shaders != current.shaders || is_clear(settings) != is_clear(current)) {
		triangle.set_shader(shader(settings));
	}
	if (!dressed || !has_equal_uniforms(settings, current)) {
		set_sky_uniforms(triangle.get_material(), settings);
	}
	if (!dressed || settings.overlays != current.overlays ||
			settings.overlay_width != current.overlay_width || settings.lensing != current.lensing) {
		triangle.set_parameter("_overlays", settings.overlays);
		triangle.set_parameter("_overlay_width", settings.overlay_width);
		triangle.set_parameter("_has_hole", settings.lensing);
	}
	dressed = true;
	current = settings;
	show();
	triangle.set_parameter("_panorama_luminance", panorama_luminance * settings.exposure);
	triangle.set_render_layers(settings.render_layers);
}
