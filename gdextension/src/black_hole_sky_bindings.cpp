// SPDX-License-Identifier: MIT
// What the engine sees of BlackHoleSky: properties, methods and the warnings in the editor.
#include "src/black_hole_sky.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/environment.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>

using namespace godot;

namespace {

/// A scene that is edited lies in a viewport of the editor's that nobody looks at; those that show it follow
/// the project's setting. Compatibility adds up display values whatever the buffer.
bool has_hdr(const Viewport *viewport) {
	if (viewport->is_using_hdr_2d() ||
			RenderingServer::get_singleton()->get_current_rendering_method() == "gl_compatibility") {
		return true;
	}
	return Engine::get_singleton()->is_editor_hint() &&
			static_cast<bool>(
					ProjectSettings::get_singleton()->get_setting("rendering/viewport/hdr_2d", false));
}

/// Whether the import has left of a picture with a high dynamic range less than its file holds.
bool is_crushed(const Ref<Texture2D> &panorama) {
	const String kind = panorama->get_path().get_extension().to_lower();
	if (kind != "exr" && kind != "hdr") {
		return false;
	}
	const int format = RenderingServer::get_singleton()->texture_get_format(panorama->get_rid());
	const bool is_known = format < Image::FORMAT_MAX; // not where nothing is drawn
	return is_known && (format > Image::FORMAT_RGBE9995 || format < Image::FORMAT_RF);
}

} // namespace

PackedStringArray BlackHoleSky::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (table.is_null() || !table->is_ready()) {
		warnings.push_back(
				"There is no lensing table, so light goes straight. Give `table` a LensingTable whose "
				"source_file is res://addons/blackhole_sky/data/schwarzschild.lut, or call its bake().");
	}
	// Where there is a room there need not be stars.
	const bool in_a_room = background == BACKGROUND_SURROUNDINGS;
	if (!in_a_room && (catalogue.is_null() || catalogue->get_star_count() == 0)) {
		warnings.push_back("There are no stars. Give `catalogue` a StarCatalogue whose source_file is "
						   "res://addons/blackhole_sky/data/hipparcos.stars or a CSV file.");
	}
	if (background == BACKGROUND_PANORAMA && panorama.is_null()) {
		warnings.push_back("The background is a panorama, but none is set. Set `panorama`, or choose another "
						   "background.");
	}
	if (panorama.is_valid() && is_crushed(panorama)) {
		warnings.push_back(vformat(
				"The panorama %s was compressed when it was imported, so that dark parts show bands. In "
				"the Import dock set Compress > Mode to VRAM Uncompressed and Detect 3D > Compress To to "
				"Disabled, and press Reimport.",
				panorama->get_path()));
	}
	if (background == BACKGROUND_CUBEMAP && cubemap.is_null()) {
		warnings.push_back("The background is a cube map, but none is set. Set `cubemap`, or choose another "
						   "background.");
	}
	if (background == BACKGROUND_SURROUNDINGS && surroundings.is_null()) {
		warnings.push_back("The background is the surroundings, but nothing captures them. Add a "
						   "SurroundingsCapture as a child, or choose another background.");
	}
	if ((overlays & OVERLAY_CONSTELLATIONS) != 0 && figure_field.is_null()) {
		warnings.push_back("Constellation figures are switched on, but there are none. Give `figure_field` "
						   "the cube map of "
						   "ConstellationOverlay.bake().");
	}
	if (!is_inside_tree()) {
		return warnings;
	}
	const Basis basis = get_global_transform().basis;
	if (!basis.is_equal_approx(basis.orthonormalized())) {
		warnings.push_back(
				"The node is scaled, which changes nothing here. Set the size by `schwarzschild_radius`.");
	}
	if (!has_hdr(get_viewport())) {
		warnings.push_back(
				"The viewport has no HDR 2D buffer, so faint stars are lost in the Mobile renderer. Switch "
				"on the project setting rendering/viewport/hdr_2d (or the SubViewport's use_hdr_2d).");
	}
	const Ref<Environment> environment = get_world_3d()->get_environment();
	if (environment.is_valid()) {
		const String where = Engine::get_singleton()->is_editor_hint()
				? " If it is the editor's preview, add a WorldEnvironment of your own, or switch the preview "
				  "off "
				  "in the toolbar of the 3D view."
				: "";
		if (environment->get_tonemapper() != Environment::TONE_MAPPER_LINEAR) {
			warnings.push_back(
					"The environment's tone mapper bends star brightness. Set it to Linear." + where);
		}
		if (environment->is_fog_enabled() || environment->is_volumetric_fog_enabled()) {
			warnings.push_back("The environment's fog would veil the sky. Switch it off." + where);
		}
		if (environment->get_background() == Environment::BG_SKY) {
			warnings.push_back("The environment draws a sky of its own, unbent. Set its background to Custom "
							   "Color, black." +
					where);
		}
	}
	return warnings;
}

void BlackHoleSky::_bind_methods() {
	ClassDB::bind_method(
			D_METHOD("set_schwarzschild_radius", "metres"), &BlackHoleSky::set_schwarzschild_radius);
	ClassDB::bind_method(D_METHOD("get_schwarzschild_radius"), &BlackHoleSky::get_schwarzschild_radius);
	ClassDB::bind_method(D_METHOD("set_mass_solar", "masses"), &BlackHoleSky::set_mass_solar);
	ClassDB::bind_method(D_METHOD("get_mass_solar"), &BlackHoleSky::get_mass_solar);
	ClassDB::bind_method(D_METHOD("get_length_unit_km"), &BlackHoleSky::get_length_unit_km);
	ClassDB::bind_method(D_METHOD("get_time_unit_seconds"), &BlackHoleSky::get_time_unit_seconds);
	ClassDB::bind_method(D_METHOD("get_acceleration_unit_g"), &BlackHoleSky::get_acceleration_unit_g);
	ClassDB::bind_method(D_METHOD("set_lensing", "fraction"), &BlackHoleSky::set_lensing);
	ClassDB::bind_method(D_METHOD("get_lensing"), &BlackHoleSky::get_lensing);
	ClassDB::bind_method(D_METHOD("set_observer_motion", "motion"), &BlackHoleSky::set_observer_motion);
	ClassDB::bind_method(D_METHOD("get_observer_motion"), &BlackHoleSky::get_observer_motion);
	ClassDB::bind_method(D_METHOD("set_observer", "observer"), &BlackHoleSky::set_observer);
	ClassDB::bind_method(D_METHOD("get_observer"), &BlackHoleSky::get_observer);
	ClassDB::bind_method(D_METHOD("set_table", "table"), &BlackHoleSky::set_table);
	ClassDB::bind_method(D_METHOD("get_table"), &BlackHoleSky::get_table);
	ClassDB::bind_method(D_METHOD("set_catalogue", "catalogue"), &BlackHoleSky::set_catalogue);
	ClassDB::bind_method(D_METHOD("get_catalogue"), &BlackHoleSky::get_catalogue);
	ClassDB::bind_method(D_METHOD("set_stars_visible", "shown"), &BlackHoleSky::set_stars_visible);
	ClassDB::bind_method(D_METHOD("are_stars_visible"), &BlackHoleSky::are_stars_visible);
	ClassDB::bind_method(D_METHOD("set_magnitude_limit", "magnitude"), &BlackHoleSky::set_magnitude_limit);
	ClassDB::bind_method(D_METHOD("get_magnitude_limit"), &BlackHoleSky::get_magnitude_limit);
	ClassDB::bind_method(D_METHOD("set_image_orders", "orders"), &BlackHoleSky::set_image_orders);
	ClassDB::bind_method(D_METHOD("get_image_orders"), &BlackHoleSky::get_image_orders);
	ClassDB::bind_method(D_METHOD("set_psf_model", "model"), &BlackHoleSky::set_psf_model);
	ClassDB::bind_method(D_METHOD("get_psf_model"), &BlackHoleSky::get_psf_model);
	ClassDB::bind_method(D_METHOD("set_aperture_mm", "millimetres"), &BlackHoleSky::set_aperture_mm);
	ClassDB::bind_method(D_METHOD("get_aperture_mm"), &BlackHoleSky::get_aperture_mm);
	ClassDB::bind_method(D_METHOD("set_glare", "share"), &BlackHoleSky::set_glare);
	ClassDB::bind_method(D_METHOD("get_glare"), &BlackHoleSky::get_glare);
	ClassDB::bind_method(D_METHOD("set_psf_sigma", "pixels"), &BlackHoleSky::set_psf_sigma);
	ClassDB::bind_method(D_METHOD("get_psf_sigma"), &BlackHoleSky::get_psf_sigma);
	ClassDB::bind_method(D_METHOD("set_faint_limit", "luminance"), &BlackHoleSky::set_faint_limit);
	ClassDB::bind_method(D_METHOD("get_faint_limit"), &BlackHoleSky::get_faint_limit);
	ClassDB::bind_method(D_METHOD("set_effect", "effect", "on"), &BlackHoleSky::set_effect);
	ClassDB::bind_method(D_METHOD("is_effect_on", "effect"), &BlackHoleSky::is_effect_on);
	ClassDB::bind_method(D_METHOD("set_higher_orders", "shown"), &BlackHoleSky::set_higher_orders);
	ClassDB::bind_method(D_METHOD("are_higher_orders_shown"), &BlackHoleSky::are_higher_orders_shown);
	ClassDB::bind_method(D_METHOD("set_saturation", "factor"), &BlackHoleSky::set_saturation);
	ClassDB::bind_method(D_METHOD("get_saturation"), &BlackHoleSky::get_saturation);
	ClassDB::bind_method(
			D_METHOD("set_stereo_baseline_scale", "factor"), &BlackHoleSky::set_stereo_baseline_scale);
	ClassDB::bind_method(D_METHOD("get_stereo_baseline_scale"), &BlackHoleSky::get_stereo_baseline_scale);
	ClassDB::bind_method(D_METHOD("set_see_through", "share"), &BlackHoleSky::set_see_through);
	ClassDB::bind_method(D_METHOD("get_see_through"), &BlackHoleSky::get_see_through);
	ClassDB::bind_method(D_METHOD("set_redshift_map", "shown"), &BlackHoleSky::set_redshift_map);
	ClassDB::bind_method(D_METHOD("is_redshift_map_shown"), &BlackHoleSky::is_redshift_map_shown);
	ClassDB::bind_method(D_METHOD("set_overlays", "shown"), &BlackHoleSky::set_overlays);
	ClassDB::bind_method(D_METHOD("get_overlays"), &BlackHoleSky::get_overlays);
	ClassDB::bind_method(D_METHOD("set_overlay_width", "pixels"), &BlackHoleSky::set_overlay_width);
	ClassDB::bind_method(D_METHOD("get_overlay_width"), &BlackHoleSky::get_overlay_width);
	ClassDB::bind_method(D_METHOD("set_figure_field", "field"), &BlackHoleSky::set_figure_field);
	ClassDB::bind_method(D_METHOD("get_figure_field"), &BlackHoleSky::get_figure_field);
	ClassDB::bind_method(D_METHOD("set_projection", "kind"), &BlackHoleSky::set_projection);
	ClassDB::bind_method(D_METHOD("get_projection"), &BlackHoleSky::get_projection);
	ClassDB::bind_method(D_METHOD("set_exposure", "ev"), &BlackHoleSky::set_exposure);
	ClassDB::bind_method(D_METHOD("get_exposure"), &BlackHoleSky::get_exposure);
	ClassDB::bind_method(D_METHOD("set_auto_exposure", "on"), &BlackHoleSky::set_auto_exposure);
	ClassDB::bind_method(D_METHOD("is_auto_exposure"), &BlackHoleSky::is_auto_exposure);
	ClassDB::bind_method(D_METHOD("set_auto_exposure_min_ev", "ev"), &BlackHoleSky::set_auto_exposure_min_ev);
	ClassDB::bind_method(D_METHOD("get_auto_exposure_min_ev"), &BlackHoleSky::get_auto_exposure_min_ev);
	ClassDB::bind_method(D_METHOD("set_auto_exposure_max_ev", "ev"), &BlackHoleSky::set_auto_exposure_max_ev);
	ClassDB::bind_method(D_METHOD("get_auto_exposure_max_ev"), &BlackHoleSky::get_auto_exposure_max_ev);
	ClassDB::bind_method(D_METHOD("set_adaptation_speed", "factor"), &BlackHoleSky::set_adaptation_speed);
	ClassDB::bind_method(D_METHOD("get_adaptation_speed"), &BlackHoleSky::get_adaptation_speed);
	ClassDB::bind_method(D_METHOD("get_effective_exposure"), &BlackHoleSky::get_effective_exposure);
	ClassDB::bind_method(D_METHOD("adapt", "seconds"), &BlackHoleSky::adapt);
	ClassDB::bind_method(D_METHOD("adapt_at_once"), &BlackHoleSky::adapt_at_once);
	ClassDB::bind_method(D_METHOD("set_background", "kind"), &BlackHoleSky::set_background);
	ClassDB::bind_method(D_METHOD("get_background"), &BlackHoleSky::get_background);
	ClassDB::bind_method(D_METHOD("set_panorama", "texture"), &BlackHoleSky::set_panorama);
	ClassDB::bind_method(D_METHOD("get_panorama"), &BlackHoleSky::get_panorama);
	ClassDB::bind_method(D_METHOD("set_cubemap", "texture"), &BlackHoleSky::set_cubemap);
	ClassDB::bind_method(D_METHOD("get_cubemap"), &BlackHoleSky::get_cubemap);
	ClassDB::bind_method(D_METHOD("set_surroundings", "texture"), &BlackHoleSky::set_surroundings);
	ClassDB::bind_method(D_METHOD("get_surroundings"), &BlackHoleSky::get_surroundings);
	ClassDB::bind_method(
			D_METHOD("set_panorama_luminance", "luminance"), &BlackHoleSky::set_panorama_luminance);
	ClassDB::bind_method(D_METHOD("get_panorama_luminance"), &BlackHoleSky::get_panorama_luminance);
	ClassDB::bind_method(D_METHOD("set_panorama_is_light", "is_light"), &BlackHoleSky::set_panorama_is_light);
	ClassDB::bind_method(D_METHOD("is_panorama_light"), &BlackHoleSky::is_panorama_light);
	ClassDB::bind_method(D_METHOD("set_render_layers", "layers"), &BlackHoleSky::set_render_layers);
	ClassDB::bind_method(D_METHOD("get_render_layers"), &BlackHoleSky::get_render_layers);
	ClassDB::bind_method(D_METHOD("add_material", "material"), &BlackHoleSky::add_material);
	ClassDB::bind_method(D_METHOD("remove_material", "material"), &BlackHoleSky::remove_material);
	ClassDB::bind_method(D_METHOD("distance_to", "world_position"), &BlackHoleSky::distance_to);
	ClassDB::bind_method(D_METHOD("shadow_angle_at", "world_position"), &BlackHoleSky::shadow_angle_at);
	ClassDB::bind_method(
			D_METHOD("get_observer_refusal_at", "world_position"), &BlackHoleSky::get_observer_refusal_at);
	ClassDB::bind_method(D_METHOD("project_image", "camera", "direction", "order"),
			&BlackHoleSky::project_image, DEFVAL(0));
	ClassDB::bind_method(D_METHOD("get_star_buffer_bytes"), &BlackHoleSky::get_star_buffer_bytes);
	ClassDB::bind_method(D_METHOD("get_update_time_ms"), &BlackHoleSky::get_update_time_ms);
	ClassDB::bind_method(D_METHOD("get_warnings"), &BlackHoleSky::_get_configuration_warnings);

	ADD_GROUP("Hole", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "schwarzschild_radius", PROPERTY_HINT_RANGE,
						 "0.001,1000,0.001,or_greater,exp,suffix:m"),
			"set_schwarzschild_radius", "get_schwarzschild_radius");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "mass_solar", PROPERTY_HINT_RANGE,
						 String::utf8("1,10000000000,0.1,or_less,or_greater,exp,suffix:M☉")),
			"set_mass_solar", "get_mass_solar");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "lensing", PROPERTY_HINT_RANGE, "0,1,0.001"), "set_lensing",
			"get_lensing");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "observer", PROPERTY_HINT_RESOURCE_TYPE, "SkyObserver"),
			"set_observer", "get_observer");
	// A short cut to observer.motion, which holds the value.
	ADD_PROPERTY(PropertyInfo(Variant::INT, "observer_motion", PROPERTY_HINT_ENUM,
						 "Static,Rain,Infall,Orbit,Velocity", PROPERTY_USAGE_NONE),
			"set_observer_motion", "get_observer_motion");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "table", PROPERTY_HINT_RESOURCE_TYPE, "LensingTable"),
			"set_table", "get_table");
	ADD_GROUP("Stars", "");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "catalogue", PROPERTY_HINT_RESOURCE_TYPE, "StarCatalogue"),
			"set_catalogue", "get_catalogue");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "stars_visible"), "set_stars_visible", "are_stars_visible");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "magnitude_limit", PROPERTY_HINT_RANGE,
						 "-2,15,0.1,or_greater,suffix:mag"),
			"set_magnitude_limit", "get_magnitude_limit");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "image_orders", PROPERTY_HINT_RANGE, "1,4"), "set_image_orders",
			"get_image_orders");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "psf_model", PROPERTY_HINT_ENUM, "Gaussian,Airy,Eye"),
			"set_psf_model", "get_psf_model");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "psf_sigma", PROPERTY_HINT_RANGE, "0.5,5,0.05,or_greater,suffix:px"),
			"set_psf_sigma", "get_psf_sigma");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "aperture_mm", PROPERTY_HINT_RANGE, "0.1,10000,0.1,exp,suffix:mm"),
			"set_aperture_mm", "get_aperture_mm");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "glare", PROPERTY_HINT_RANGE, "0,1,0.001"), "set_glare",
			"get_glare");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "faint_limit", PROPERTY_HINT_RANGE, "0.000001,0.01,0.000001,exp"),
			"set_faint_limit", "get_faint_limit");
	ADD_GROUP("Effects", "effect_");
	ADD_PROPERTYI(PropertyInfo(Variant::BOOL, "effect_deflection"), "set_effect", "is_effect_on",
			EFFECT_DEFLECTION);
	ADD_PROPERTYI(PropertyInfo(Variant::BOOL, "effect_aberration"), "set_effect", "is_effect_on",
			EFFECT_ABERRATION);
	ADD_PROPERTYI(PropertyInfo(Variant::BOOL, "effect_gravitational_shift"), "set_effect", "is_effect_on",
			EFFECT_GRAVITATIONAL_SHIFT);
	ADD_PROPERTYI(
			PropertyInfo(Variant::BOOL, "effect_doppler"), "set_effect", "is_effect_on", EFFECT_DOPPLER);
	ADD_PROPERTYI(PropertyInfo(Variant::BOOL, "effect_magnification"), "set_effect", "is_effect_on",
			EFFECT_MAGNIFICATION);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "effect_higher_orders"), "set_higher_orders",
			"are_higher_orders_shown");
	ADD_GROUP("Overlays", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "overlays", PROPERTY_HINT_FLAGS,
						 "Constellations,Equatorial Grid,Galactic Grid,Shadow Edge,Einstein Rings,Direction "
						 "of Motion,"
						 "Shadow Diameter,Straight Light"),
			"set_overlays", "get_overlays");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "overlay_width", PROPERTY_HINT_RANGE,
						 "0.5,5,0.1,or_greater,suffix:px"),
			"set_overlay_width", "get_overlay_width");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "figure_field", PROPERTY_HINT_RESOURCE_TYPE, "Cubemap"),
			"set_figure_field", "get_figure_field");
	ADD_GROUP("Projection", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "projection", PROPERTY_HINT_ENUM,
						 String::utf8("Perspective,Equirectangular,Mercator,Mollweide,Fisheye 180°,Fisheye "
									  "220°,Fisheye 360°")),
			"set_projection", "get_projection");
	ADD_GROUP("Exposure", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "exposure", PROPERTY_HINT_RANGE,
						 "-10,10,0.1,or_less,or_greater,suffix:EV"),
			"set_exposure", "get_exposure");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "auto_exposure"), "set_auto_exposure", "is_auto_exposure");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "auto_exposure_min_ev", PROPERTY_HINT_RANGE,
						 "-20,20,0.1,or_less,or_greater,suffix:EV"),
			"set_auto_exposure_min_ev", "get_auto_exposure_min_ev");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "auto_exposure_max_ev", PROPERTY_HINT_RANGE,
						 "-20,20,0.1,or_less,or_greater,suffix:EV"),
			"set_auto_exposure_max_ev", "get_auto_exposure_max_ev");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "adaptation_speed", PROPERTY_HINT_RANGE,
						 String::utf8("0,10,0.01,or_greater,suffix:×")),
			"set_adaptation_speed", "get_adaptation_speed");
	ADD_GROUP("Picture", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "saturation", PROPERTY_HINT_RANGE, "0,4,0.01"),
			"set_saturation", "get_saturation");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "stereo_baseline_scale", PROPERTY_HINT_RANGE, "0,1,0.01"),
			"set_stereo_baseline_scale", "get_stereo_baseline_scale");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "see_through", PROPERTY_HINT_RANGE, "0,1,0.01"),
			"set_see_through", "get_see_through");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "redshift_map"), "set_redshift_map", "is_redshift_map_shown");
	ADD_GROUP("Background", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "background", PROPERTY_HINT_ENUM,
						 "None,Grid,Panorama,Cubemap,Surroundings"),
			"set_background", "get_background");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "panorama", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"),
			"set_panorama", "get_panorama");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "cubemap", PROPERTY_HINT_RESOURCE_TYPE, "Cubemap"),
			"set_cubemap", "get_cubemap");
	// Drawn while the scene runs, so there is nothing to be stored.
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "surroundings", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D",
						 PROPERTY_USAGE_NONE),
			"set_surroundings", "get_surroundings");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "panorama_luminance", PROPERTY_HINT_RANGE, "0,10,0.001,or_greater"),
			"set_panorama_luminance", "get_panorama_luminance");
	ADD_PROPERTY(
			PropertyInfo(Variant::BOOL, "panorama_is_light"), "set_panorama_is_light", "is_panorama_light");
	ADD_GROUP("Visibility", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "render_layers", PROPERTY_HINT_LAYERS_3D_RENDER),
			"set_render_layers", "get_render_layers");

	ADD_SIGNAL(MethodInfo("horizon_crossed", PropertyInfo(Variant::BOOL, "inward"),
			PropertyInfo(Variant::OBJECT, "camera", PROPERTY_HINT_NODE_TYPE, "Camera3D")));
	ADD_SIGNAL(MethodInfo("observer_changed"));
	ADD_SIGNAL(MethodInfo("quality_changed"));

	BIND_ENUM_CONSTANT(EFFECT_DEFLECTION);
	BIND_ENUM_CONSTANT(EFFECT_ABERRATION);
	BIND_ENUM_CONSTANT(EFFECT_GRAVITATIONAL_SHIFT);
	BIND_ENUM_CONSTANT(EFFECT_DOPPLER);
	BIND_ENUM_CONSTANT(EFFECT_MAGNIFICATION);
	BIND_ENUM_CONSTANT(OVERLAY_CONSTELLATIONS);
	BIND_ENUM_CONSTANT(OVERLAY_EQUATORIAL_GRID);
	BIND_ENUM_CONSTANT(OVERLAY_GALACTIC_GRID);
	BIND_ENUM_CONSTANT(OVERLAY_SHADOW_EDGE);
	BIND_ENUM_CONSTANT(OVERLAY_EINSTEIN_RINGS);
	BIND_ENUM_CONSTANT(OVERLAY_MOTION);
	BIND_ENUM_CONSTANT(OVERLAY_SHADOW_DIAMETER);
	BIND_ENUM_CONSTANT(OVERLAY_STRAIGHT_LIGHT);
	BIND_ENUM_CONSTANT(PROJECTION_PERSPECTIVE);
	BIND_ENUM_CONSTANT(PROJECTION_EQUIRECTANGULAR);
	BIND_ENUM_CONSTANT(PROJECTION_MERCATOR);
	BIND_ENUM_CONSTANT(PROJECTION_MOLLWEIDE);
	BIND_ENUM_CONSTANT(PROJECTION_FISHEYE_180);
	BIND_ENUM_CONSTANT(PROJECTION_FISHEYE_220);
	BIND_ENUM_CONSTANT(PROJECTION_FISHEYE_360);
	BIND_ENUM_CONSTANT(PSF_GAUSSIAN);
	BIND_ENUM_CONSTANT(PSF_AIRY);
	BIND_ENUM_CONSTANT(PSF_EYE);
	BIND_ENUM_CONSTANT(BACKGROUND_NONE);
	BIND_ENUM_CONSTANT(BACKGROUND_GRID);
	BIND_ENUM_CONSTANT(BACKGROUND_PANORAMA);
	BIND_ENUM_CONSTANT(BACKGROUND_CUBEMAP);
	BIND_ENUM_CONSTANT(BACKGROUND_SURROUNDINGS);
}
