// SPDX-License-Identifier: MIT
#include "src/disk_layer.h"

#include <algorithm>
#include <cmath>

#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/vector2.hpp>

#include "core/disk/page_thorne.h"
#include "core/photometry/radiometry.h"
#include "core/relativity/critical.h"
#include "src/draw_order.h"
#include "src/float_texture.h"
#include "src/planck_texture.h"

using namespace godot;

namespace {

/// To here plunging gas is followed [r_s], for who is there to see it.
constexpr double kDeepest = 0.1;
/// After so many lifetimes eddies are the same again.
constexpr double kGenerations = 65536.0;

const char *shader_path(SkyShaders needed, bool plain) {
	switch (needed) {
		case SkyShaders::kGeneral:
			return "res://addons/blackhole_sky/shaders/accretion_disk_general.gdshader";
		case SkyShaders::kMap:
			return "res://addons/blackhole_sky/shaders/accretion_disk_map.gdshader";
		default:
			return plain ? "res://addons/blackhole_sky/shaders/accretion_disk_plain.gdshader"
						 : "res://addons/blackhole_sky/shaders/accretion_disk_lensed.gdshader";
	}
}

Vector2 pair(double x, double y) {
	return {static_cast<real_t>(x), static_cast<real_t>(y)};
}

/// Angle [rad] from infinity to u on the critical ray, u = tanh^2((eta + eta_0)/2) - 1/3; it has no end at
/// the photon sphere.
double critical_angle(double u) {
	const double root = std::sqrt(std::min(u, 0.6666) + 1.0 / 3.0);
	return 2.0 * (std::atanh(root) - std::atanh(1.0 / blackhole::kSqrt3));
}

double log2_brightness(double exposure, double brightness_ev) {
	return blackhole::log2_luminance_unit() + std::log2(exposure) + brightness_ev;
}

/// See disk_rings.gdshaderinc.
double ring_measure(double radius) {
	return 1.0 / (radius + 2.0);
}

/// Where there is something to see of a disk [r_s].
struct Extent {
	double inner;
	double outer;
};

Extent extent_of(const DiskSettings &disk) {
	if (disk.look == DiskSettings::kRings && !disk.rings.empty()) {
		const auto [least, most] = std::minmax_element(disk.rings.begin(), disk.rings.end());
		// With room for the lines, which are as wide as pixels make them.
		return {0.8 * *least, 1.3 * *most + 0.5};
	}
	return {disk.plunging ? kDeepest : blackhole::kInnermostStable, disk.outer_radius};
}

} // namespace

bool DiskLayer::is_drawn() const {
	const bool empty = disk.look == DiskSettings::kRings && disk.rings.empty();
	return shown && !empty && scenario.is_valid() && table.is_valid() && table->is_ready();
}

void DiskLayer::make() {
	if (triangle.is_made()) {
		return;
	}
	triangle.make(kDiskPriority);
	triangle.set_parameter("_planck_table", planck_texture()->get_rid());
	triangle.set_scenario(scenario);
}

/// What is hidden is dressed when it is shown again.
void DiskLayer::refresh() {
	const bool drawn = is_drawn();
	if (drawn) {
		make();
		dress();
	}
	if (triangle.is_made()) {
		triangle.set_visible(drawn);
	}
}

void DiskLayer::set_scenario(const RID &p_scenario) {
	scenario = p_scenario;
	if (triangle.is_made()) {
		triangle.set_scenario(scenario);
	}
	refresh();
}

void DiskLayer::set_shown(bool p_shown) {
	shown = p_shown;
	refresh();
}

void DiskLayer::load_shader() {
	const SkyShaders needed = sky.shaders == SkyShaders::kFlat ? SkyShaders::kRadial : sky.shaders;
	const bool plain =
			disk.look == DiskSettings::kPhysical && !disk.plunging && disk.opacity == 1.0 && !redshift_map;
	if (shader.is_null() || needed != loaded || plain != loaded_plain) {
		shader = ResourceLoader::get_singleton()->load(shader_path(needed, plain));
		loaded = needed;
		loaded_plain = plain;
		triangle.set_shader(shader->get_rid());
	}
}

void DiskLayer::set_sky(const SkySettings &settings, double p_hole_scale, const Ref<LensingTable> &p_table,
		const DiskSettings &disk_then) {
	sky = settings;
	hole_scale = p_hole_scale;
	table = p_table;
	disk = disk_then;
	refresh();
}

void DiskLayer::set_redshift_map(bool p_shown) {
	redshift_map = p_shown;
	refresh();
}

void DiskLayer::set_disk(const DiskSettings &settings) {
	disk = settings;
	refresh();
}

void DiskLayer::set_time(const DiskSettings &settings) {
	disk.time = settings.time;
	if (!is_drawn()) {
		return;
	}
	const double stage = disk.time / disk.lifetime;
	const double gone = std::floor(stage);
	triangle.set_parameter("_turbulence", pair(disk.contrast, disk.lifetime));
	triangle.set_parameter("_stage", stage - gone);
	triangle.set_parameter("_generation", gone - kGenerations * std::floor(gone / kGenerations));
}

void DiskLayer::dress() {
	load_shader();
	set_sky_uniforms(triangle.get_material(), sky);
	triangle.set_render_layers(sky.render_layers);
	triangle.set_parameter("_forward_table", table->get_forward_texture()->get_rid());
	triangle.set_parameter("_radius_table", table->get_radius_texture()->get_rid());
	triangle.set_parameter("_delay_table", table->get_delay_texture()->get_rid());
	triangle.set_parameter("_redshift_map", redshift_map);
	triangle.set_parameter("_hole_scale", hole_scale);
	triangle.set_parameter("_disk_axes", disk.axes);
	triangle.set_parameter("_sense", disk.retrograde ? -1.0 : 1.0);
	const Extent extent = extent_of(disk);
	triangle.set_parameter("_edges", pair(1.0 / extent.outer, 1.0 / extent.inner));
	triangle.set_parameter("_ring_angles",
			pair(critical_angle(hole_scale / extent.outer), critical_angle(hole_scale / extent.inner)));
	triangle.set_parameter("_outer_fade", disk.outer_fade);
	triangle.set_parameter("_orders", disk.orders);
	triangle.set_parameter("_opacity", disk.opacity);
	triangle.set_parameter("_look", static_cast<int>(disk.look));
	triangle.set_parameter("_peak_temperature", disk.peak_temperature);
	triangle.set_parameter("_plunging", disk.plunging ? disk.plunging_temperature : 0.0);
	triangle.set_parameter("_log2_brightness", log2_brightness(sky.exposure, disk.brightness_ev));
	triangle.set_parameter("_limb_darkening", disk.limb_darkening);
	triangle.set_parameter("_checkerboard", pair(disk.sectors, disk.checker_ring_width));
	dress_rings();
	set_time(disk);
}

void DiskLayer::dress_rings() {
	const bool rings = disk.look == DiskSettings::kRings;
	triangle.set_render_priority(rings ? kRingPriority : kDiskPriority);
	if (!rings) {
		return;
	}
	PackedVector2Array places;
	places.resize(DiskSettings::kMostRings);
	for (std::size_t i = 0; i < disk.rings.size(); ++i) {
		const double measure = ring_measure(disk.rings[i]);
		double room = measure; // to infinity
		for (const double other : disk.rings) {
			const double apart = std::abs(ring_measure(other) - measure);
			room = apart > 0.0 ? std::min(room, apart) : room;
		}
		places[static_cast<int64_t>(i)] = pair(measure, room);
	}
	triangle.set_parameter("_rings", places);
	triangle.set_parameter("_ring_count", static_cast<int>(disk.rings.size()));
	triangle.set_parameter("_ring_highlight", disk.ring_highlight);
	triangle.set_parameter("_ring_width", disk.ring_width);
}
