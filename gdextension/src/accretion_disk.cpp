// SPDX-License-Identifier: MIT
#include "src/accretion_disk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include "core/disk/page_thorne.h"
#include "core/photometry/radiometry.h"
#include "src/black_hole_sky.h"
#include "src/glm_adapter.h"
#include "src/property_limits.h"

using namespace godot;

namespace {

constexpr float kLargestRing = 1e4F; // r_s

} // namespace

AccretionDisk::AccretionDisk() {
	set_notify_transform(true);
}

BlackHoleSky *AccretionDisk::parent_sky() const {
	return Object::cast_to<BlackHoleSky>(get_parent());
}

void AccretionDisk::enter_world() {
	settings.axes = get_global_transform().basis.orthonormalized();
	layer.set_scenario(get_world_3d()->get_scenario());
	layer.set_shown(is_visible_in_tree());
	if (BlackHoleSky *sky = parent_sky()) {
		sky->add_disk(this);
	}
	changed();
	update_configuration_warnings();
}

void AccretionDisk::exit_world() {
	if (BlackHoleSky *sky = parent_sky()) {
		sky->remove_disk(this);
	}
	layer.set_scenario(RID());
}

void AccretionDisk::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_WORLD:
			enter_world();
			break;
		case NOTIFICATION_EXIT_WORLD:
			exit_world();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			settings.axes = get_global_transform().basis.orthonormalized();
			changed();
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			layer.set_shown(is_visible_in_tree());
			break;
		default:
			break;
	}
}

void AccretionDisk::_process(double delta) {
	if (time_scale != 0.0 && settings.look == DiskSettings::kTurbulent && is_visible_in_tree()) {
		settings.time += delta * time_scale;
		layer.set_time(settings);
	}
}

void AccretionDisk::sky_changed(const SkySettings &sky, double hole_scale, const Ref<LensingTable> &table) {
	settings.peak_temperature = get_hottest_temperature();
	layer.set_sky(sky, hole_scale, table, settings);
	redraw_gizmo();
}

void AccretionDisk::changed() {
	settings.peak_temperature = get_hottest_temperature();
	layer.set_disk(settings);
	redraw_gizmo();
}

void AccretionDisk::redraw_gizmo() {
	if (Engine::get_singleton()->is_editor_hint()) {
		update_gizmos();
	}
}

std::optional<blackhole::GlowingDisk> AccretionDisk::metered(double hole_scale) const {
	const bool glows = settings.look == DiskSettings::kPhysical || settings.look == DiskSettings::kTurbulent;
	if (!glows || !is_visible_in_tree()) {
		return std::nullopt;
	}
	blackhole::GlowingDisk disk;
	disk.normal = to_glm(settings.axes.get_column(1));
	disk.retrograde = settings.retrograde;
	disk.outer_radius = settings.outer_radius;
	disk.hole_scale = hole_scale;
	disk.peak_temperature = settings.peak_temperature;
	disk.plunging_temperature = settings.plunging ? settings.plunging_temperature : 0.0;
	disk.opacity = settings.opacity;
	disk.log2_brightness = blackhole::log2_luminance_unit() + settings.brightness_ev;
	disk.orders = settings.orders;
	return disk;
}

double AccretionDisk::get_hottest_temperature() const {
	const BlackHoleSky *sky = parent_sky();
	if (!(accretion_rate > 0.0) || sky == nullptr) {
		return peak_temperature;
	}
	return blackhole::hottest_ring_temperature(sky->get_mass_solar(), accretion_rate);
}

void AccretionDisk::set_outer_radius(double radius) {
	settings.outer_radius = limited(radius, 3.1, 1e4, settings.outer_radius);
	changed();
}

void AccretionDisk::set_outer_fade(double share) {
	settings.outer_fade = limited(share, 0.0, 1.0, settings.outer_fade);
	changed();
}

void AccretionDisk::set_retrograde(bool on) {
	settings.retrograde = on;
	changed();
}

void AccretionDisk::set_plunging_gas(bool shown) {
	settings.plunging = shown;
	changed();
}

void AccretionDisk::set_plunging_temperature(double share) {
	settings.plunging_temperature = limited(share, 0.01, 1.0, settings.plunging_temperature);
	changed();
}

void AccretionDisk::set_peak_temperature(double kelvin) {
	peak_temperature = limited(kelvin, 250.0, 1e9, peak_temperature);
	changed();
}

void AccretionDisk::set_accretion_rate(double masses_per_year) {
	accretion_rate = limited(masses_per_year, 0.0, 1e6, accretion_rate);
	changed();
}

void AccretionDisk::set_brightness_ev(double ev) {
	settings.brightness_ev = limited(ev, -100.0, 100.0, settings.brightness_ev);
	changed();
}

void AccretionDisk::set_opacity(double share) {
	settings.opacity = limited(share, 0.0, 1.0, settings.opacity);
	changed();
}

void AccretionDisk::set_limb_darkening(bool on) {
	settings.limb_darkening = on;
	changed();
}

void AccretionDisk::set_orders(int orders) {
	settings.orders = std::clamp(orders, 1, 4);
	changed();
}

void AccretionDisk::set_look(Look look) {
	settings.look = static_cast<DiskSettings::Look>(std::clamp(look, LOOK_PHYSICAL, LOOK_RINGS));
	changed();
}

void AccretionDisk::set_turbulence(double contrast) {
	settings.contrast = limited(contrast, 0.0, 3.0, settings.contrast);
	changed();
}

void AccretionDisk::set_eddy_lifetime(double time) {
	settings.lifetime = limited(time, 1.0, 1e6, settings.lifetime);
	changed();
}

void AccretionDisk::set_checker_sectors(int sectors) {
	settings.sectors = 2 * (std::clamp(sectors, 2, 360) / 2); // an odd one would meet its like
	changed();
}

void AccretionDisk::set_checker_ring_width(double width) {
	settings.checker_ring_width = limited(width, 0.05, 1e3, settings.checker_ring_width);
	changed();
}

void AccretionDisk::set_ring_radii(const PackedFloat32Array &radii) {
	if (radii.size() > static_cast<int64_t>(DiskSettings::kMostRings)) {
		UtilityFunctions::push_warning("AccretionDisk.ring_radii: ", radii.size(),
				" rings are too many, 8 are the most. The rings stay as they were.");
		return;
	}
	for (const float radius : radii) {
		if (!(radius > 1.0F && radius <= kLargestRing)) {
			UtilityFunctions::push_warning("AccretionDisk.ring_radii: there is no ring at ", radius,
					"; a radius is above 1 and at most 10000. The rings stay as they were.");
			return;
		}
	}
	settings.rings.assign(radii.ptr(), radii.ptr() + radii.size());
	changed();
}

PackedFloat32Array AccretionDisk::get_ring_radii() const {
	PackedFloat32Array radii;
	for (const double radius : settings.rings) {
		radii.push_back(static_cast<float>(radius));
	}
	return radii;
}

void AccretionDisk::set_ring_highlight(int place) {
	settings.ring_highlight = std::clamp(place, -1, static_cast<int>(DiskSettings::kMostRings) - 1);
	changed();
}

void AccretionDisk::set_ring_width(double pixels) {
	settings.ring_width = limited(pixels, 0.5, 20.0, settings.ring_width);
	changed();
}

void AccretionDisk::set_time(double time) {
	settings.time = limited(time, -1e12, 1e12, settings.time);
	layer.set_time(settings);
}

void AccretionDisk::set_time_scale(double factor) {
	time_scale = limited(factor, -1e6, 1e6, time_scale);
}

double AccretionDisk::page_thorne_temperature(double radius) {
	return blackhole::page_thorne_temperature(radius);
}

double AccretionDisk::orbital_period(double radius) {
	return radius > 1.5 ? 2.0 * std::numbers::pi * std::sqrt(2.0 * radius * radius * radius)
						: std::numeric_limits<double>::quiet_NaN();
}
