// SPDX-License-Identifier: MIT
#include "src/black_hole_sky.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include "core/relativity/physical_scale.h"
#include "core/relativity/shadow.h"
#include "src/accretion_disk.h"
#include "src/glm_adapter.h"
#include "src/image_projector.h"
#include "src/planck_texture.h"
#include "src/property_limits.h"

using namespace godot;

namespace {

/// Of the node's hole, the part that counts as none.
constexpr double kVanished = 1e-6;
constexpr double kLargest = 1e30; // of lengths and luminances, within single precision

} // namespace

BlackHoleSky::BlackHoleSky() {
	set_notify_transform(true);
}

double BlackHoleSky::hole_scale() const {
	return std::max(lensing, kVanished);
}

bool BlackHoleSky::is_lensing() const {
	return lensing > kVanished && table.is_valid() && table->is_ready();
}

SkyShaders BlackHoleSky::shaders_needed() const {
	if (projection != PROJECTION_PERSPECTIVE) {
		return SkyShaders::kMap;
	}
	if (!is_lensing() && see_through > 0.0) {
		return SkyShaders::kGeneral;
	}
	const LensingTable::Motion motion = get_observer_motion();
	const bool radial = motion != LensingTable::MOTION_ORBIT && motion != LensingTable::MOTION_VELOCITY;
	if (is_lensing()) {
		const bool usual = radial && effects == lensing_shader::kAllEffects && overlays == 0;
		return usual ? SkyShaders::kRadial : SkyShaders::kGeneral;
	}
	// Without the hole a given velocity still aberrates and shifts; the other motions are the hole's.
	const bool flies = motion == LensingTable::MOTION_VELOCITY;
	return flies || overlays != 0 ? SkyShaders::kGeneral : SkyShaders::kFlat;
}

void BlackHoleSky::enter_world() {
	const RID scenario = get_world_3d()->get_scenario();
	star_layer.set_scenario(scenario);
	background_layer.set_scenario(scenario);
	star_layer.set_shown(stars_visible && is_visible_in_tree());
	background_layer.set_shown(is_visible_in_tree());
	SceneTree *tree = get_tree();
	eye_tracker.scan(tree->get_root());
	tree->connect("node_added", callable_mp(this, &BlackHoleSky::node_added));
	tree->connect("node_removed", callable_mp(this, &BlackHoleSky::node_removed));
	// The last moment before drawing: cameras have moved by then, so nothing lags a frame behind.
	RenderingServer::get_singleton()->connect(
			"frame_pre_draw", callable_mp(this, &BlackHoleSky::before_draw));
	// The Compatibility renderer does not.
	reads_cubemaps = RenderingServer::get_singleton()->get_current_rendering_method() != "gl_compatibility";
	exposure_meter.begin();
	apply_settings();
}

void BlackHoleSky::exit_world() {
	horizon_watch.forget();
	RenderingServer::get_singleton()->disconnect(
			"frame_pre_draw", callable_mp(this, &BlackHoleSky::before_draw));
	SceneTree *tree = get_tree();
	tree->disconnect("node_added", callable_mp(this, &BlackHoleSky::node_added));
	tree->disconnect("node_removed", callable_mp(this, &BlackHoleSky::node_removed));
	eye_tracker.clear();
	star_layer.set_scenario(RID());
	background_layer.set_scenario(RID());
}

void BlackHoleSky::node_added(Node *node) {
	eye_tracker.add(node);
}

void BlackHoleSky::node_removed(Node *node) {
	eye_tracker.remove(node);
}

void BlackHoleSky::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_WORLD:
			enter_world();
			break;
		case NOTIFICATION_EXIT_WORLD:
			exit_world();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			settings_changed();
			update_configuration_warnings();
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			star_layer.set_shown(stars_visible && is_visible_in_tree());
			background_layer.set_shown(is_visible_in_tree());
			break;
		default:
			break;
	}
}

void BlackHoleSky::settings_changed() {
	settings_dirty = true;
	if (Engine::get_singleton()->is_editor_hint()) {
		update_gizmos(); // and so a frame is drawn: the editor draws none while it believes that nothing
						 // changed
	}
}

void BlackHoleSky::apply_settings() {
	settings_dirty = false;
	const Transform3D place = get_global_transform();
	settings.hole_position = place.origin;
	settings.sky_to_world = place.basis.orthonormalized();
	settings.lensing = is_lensing();
	settings.inverse_radius = 1.0 / (schwarzschild_radius * hole_scale());
	settings.shaders = shaders_needed();
	settings.observer = observer_field();
	settings.observer.axis = to_glm(settings.sky_to_world.xform(to_godot(settings.observer.axis)));
	settings.observer.celerity = to_glm(settings.sky_to_world.xform(to_godot(settings.observer.celerity)));
	settings.effects = effects;
	settings.projection = projection;
	settings.overlays = figure_field.is_valid() ? overlays : overlays & ~OVERLAY_CONSTELLATIONS;
	settings.overlay_width = overlay_width;
	if (!settings.lensing) {
		// Only a given velocity is one without the hole.
		if (get_observer_motion() != LensingTable::MOTION_VELOCITY) {
			settings.observer = blackhole::ObserverField();
		}
		// A place where the hole is of no account, and no rain falls.
		settings.hole_position = Vector3(0, 1e9, 0);
		settings.inverse_radius = 1.0;
		settings.effects &= ~(EFFECT_DEFLECTION | EFFECT_GRAVITATIONAL_SHIFT);
	}
	settings.saturation = saturation;
	settings.stereo_baseline_scale = stereo_baseline_scale;
	settings.see_through = see_through;
	applied_exposure = get_effective_exposure();
	settings.exposure = std::exp2(applied_exposure);
	settings.psf_model = static_cast<blackhole::PointSpread>(psf_model);
	settings.psf_sigma = psf_sigma;
	settings.aperture = 1e-3 * aperture_mm;
	settings.glare = glare;
	settings.faint_limit = faint_limit;
	settings.magnitude_limit = magnitude_limit;
	settings.image_orders = higher_orders && is_effect_on(EFFECT_DEFLECTION) ? image_orders : 1;
	settings.render_layers = render_layers;
	star_layer.apply(settings);
	background_layer.apply(settings);
	apply_to_disks();
	apply_to_materials();
	star_choice.reset();
}

void BlackHoleSky::before_draw() {
	const auto start = std::chrono::steady_clock::now();
	const std::vector<WatchingEye> &eyes = eye_tracker.eyes_in(get_world_3d(), render_layers);
	if (!tell_of_horizon(eyes)) {
		return;
	}
	if (is_metering() && !eyes.empty() && can_process() && is_visible_in_tree()) {
		meter(eyes.front(), get_process_delta_time(), false);
	}
	if (settings_dirty) {
		apply_settings();
	}
	if (settings.lensing) {
		star_choice.update(star_layer, settings, eyes, *table->data());
	}
	const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
	update_time_ms = spent.count();
}

void BlackHoleSky::catalogue_changed() {
	exposure_meter.forget_stars();
	if (catalogue.is_valid()) {
		star_layer.build(catalogue->table());
		if (is_inside_tree()) {
			star_layer.set_scenario(get_world_3d()->get_scenario());
		}
		table_changed();
	} else {
		star_layer.clear();
	}
	update_configuration_warnings();
}

void BlackHoleSky::table_changed() {
	RID inverse;
	RID forward;
	if (table.is_valid() && table->is_ready()) {
		inverse = table->get_inverse_texture()->get_rid();
		forward = table->get_forward_texture()->get_rid();
	}
	star_layer.set_textures(inverse, planck_texture()->get_rid());
	background_layer.set_tables(forward, inverse, planck_texture()->get_rid());
	settings_changed();
	update_configuration_warnings();
}

void BlackHoleSky::set_catalogue(const Ref<StarCatalogue> &p_catalogue) {
	const Callable changed = callable_mp(this, &BlackHoleSky::catalogue_changed);
	if (catalogue.is_valid() && catalogue->is_connected("changed", changed)) {
		catalogue->disconnect("changed", changed);
	}
	catalogue = p_catalogue;
	if (catalogue.is_valid()) {
		catalogue->connect("changed", changed);
	}
	catalogue_changed();
}

void BlackHoleSky::set_table(const Ref<LensingTable> &p_table) {
	const Callable changed = callable_mp(this, &BlackHoleSky::table_changed);
	if (table.is_valid() && table->is_connected("changed", changed)) {
		table->disconnect("changed", changed);
	}
	table = p_table;
	if (table.is_valid()) {
		table->connect("changed", changed);
	}
	table_changed();
}

void BlackHoleSky::set_schwarzschild_radius(double metres) {
	schwarzschild_radius = limited(metres, 1e-6, kLargest, schwarzschild_radius);
	settings_changed();
}

void BlackHoleSky::set_mass_solar(double masses) {
	mass_solar = limited(masses, 1e-12, kLargest, mass_solar);
	settings_changed(); // disks heat up by it
}

double BlackHoleSky::get_length_unit_km() const {
	return blackhole::PhysicalScale::of_mass(mass_solar).value->metres() / 1000.0;
}

double BlackHoleSky::get_time_unit_seconds() const {
	return blackhole::PhysicalScale::of_mass(mass_solar).value->seconds();
}

double BlackHoleSky::get_acceleration_unit_g() const {
	return blackhole::PhysicalScale::of_mass(mass_solar).value->standard_gravities();
}

void BlackHoleSky::set_lensing(double fraction) {
	lensing = limited(fraction, 0.0, 1.0, lensing);
	settings_changed();
}

void BlackHoleSky::set_effect(int effect, bool on) {
	effects = on ? effects | effect : effects & ~effect;
	settings_changed();
}

void BlackHoleSky::set_overlays(int shown) {
	overlays = shown;
	settings_changed();
	update_configuration_warnings();
}

void BlackHoleSky::set_overlay_width(double pixels) {
	overlay_width = limited(pixels, 0.5, 20.0, overlay_width);
	settings_changed();
}

void BlackHoleSky::set_figure_field(const Ref<Cubemap> &field) {
	figure_field = field;
	background_layer.set_figure_field(field.is_valid() ? field->get_rid() : RID());
	settings_changed();
	update_configuration_warnings();
}

void BlackHoleSky::set_projection(Projection kind) {
	projection = kind;
	settings_changed();
}

void BlackHoleSky::set_saturation(double factor) {
	saturation = limited(factor, 0.0, 4.0, saturation);
	settings_changed();
}

void BlackHoleSky::set_stereo_baseline_scale(double factor) {
	stereo_baseline_scale = limited(factor, 0.0, 1.0, stereo_baseline_scale);
	settings_changed();
}

void BlackHoleSky::set_see_through(double share) {
	see_through = limited(share, 0.0, 1.0, see_through);
	settings_changed();
}

void BlackHoleSky::set_redshift_map(bool shown) {
	redshift_map = shown;
	background_layer.set_redshift_map(shown);
	for (AccretionDisk *disk : disks) {
		disk->redshift_map_changed(shown);
	}
}

void BlackHoleSky::set_stars_visible(bool shown) {
	stars_visible = shown;
	star_layer.set_shown(stars_visible && is_inside_tree() && is_visible_in_tree());
}

void BlackHoleSky::set_aperture_mm(double millimetres) {
	aperture_mm = limited(millimetres, 0.1, 1e4, aperture_mm);
	settings_changed();
}

void BlackHoleSky::set_glare(double share) {
	glare = limited(share, 0.0, 1.0, glare);
	settings_changed();
}

void BlackHoleSky::set_psf_sigma(double pixels) {
	psf_sigma = limited(pixels, 0.3, 32.0, psf_sigma);
	settings_changed();
}

void BlackHoleSky::set_exposure(double ev) {
	exposure = limited(ev, -40.0, 60.0, exposure);
	settings_changed();
}

void BlackHoleSky::set_render_layers(uint32_t layers) {
	render_layers = layers;
	settings_changed();
}

double BlackHoleSky::distance_to(const Vector3 &world_position) const {
	return world_position.distance_to(get_global_transform().origin) / schwarzschild_radius;
}

Vector3 BlackHoleSky::place_of(const Vector3 &world_position) const {
	const Transform3D place = get_global_transform();
	const Vector3 offset = place.basis.orthonormalized().transposed().xform(world_position - place.origin);
	return offset / static_cast<real_t>(schwarzschild_radius * hole_scale());
}

double BlackHoleSky::shadow_angle_at(const Vector3 &world_position) const {
	if (!is_lensing()) {
		return 0.0;
	}
	const glm::dvec3 place = to_glm(place_of(world_position));
	auto shadow = blackhole::apparent_shadow(place, observer_field());
	if (!shadow) {
		shadow = blackhole::apparent_shadow(place, blackhole::ObserverMotion::kRain);
	}
	return shadow ? 2.0 * shadow.value->half_angle : 0.0;
}

String BlackHoleSky::get_observer_refusal_at(const Vector3 &world_position) const {
	if (!is_lensing()) {
		return {};
	}
	const auto at = blackhole::local_observer(observer_field(), to_glm(place_of(world_position)));
	return at ? String() : String::utf8(at.error.c_str());
}

Vector2 BlackHoleSky::project_image(Camera3D *camera, const Vector3 &direction, int order) {
	constexpr real_t kNowhere = std::numeric_limits<real_t>::infinity();
	const Vector2 nowhere(kNowhere, kNowhere);
	const bool asked_well = camera != nullptr && camera->is_inside_tree() && direction.is_finite() &&
			direction.length_squared() > 0 && order >= 0 && order < StarLayer::kMaxOrders;
	if (!asked_well || !is_inside_tree()) {
		return nowhere;
	}
	if (settings_dirty) {
		apply_settings();
	}
	if (order > 0 && (!settings.lensing || order >= settings.image_orders)) {
		return nowhere;
	}
	return ::project_image(settings, is_lensing() ? table->data().get() : nullptr, camera, direction, order)
			.value_or(nowhere);
}
