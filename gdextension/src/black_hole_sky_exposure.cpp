// SPDX-License-Identifier: MIT
// The automatic exposure of BlackHoleSky: what it meters and when the picture follows.
#include "src/black_hole_sky.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/accretion_disk.h"
#include "src/property_limits.h"

using namespace godot;

namespace {

constexpr double kDarkest = -40.0; // EV
constexpr double kBrightest = 60.0;
/// The settings follow an exposure that has moved by this: less is not seen, and setting them costs time.
constexpr double kStep = 0.01;

} // namespace

/// The surroundings are as bright as the scene that they are of.
bool BlackHoleSky::is_metering() const {
	const bool readable = background != BACKGROUND_CUBEMAP || reads_cubemaps;
	return auto_exposure && readable && background != BACKGROUND_SURROUNDINGS;
}

void BlackHoleSky::set_auto_exposure(bool on) {
	if (on == auto_exposure) {
		return;
	}
	auto_exposure = on;
	// Before the eyes of a visitor the picture goes on from the manual exposure.
	if (on && is_inside_tree()) {
		exposure_meter.begin_from(0.0);
	}
	settings_changed();
}

void BlackHoleSky::set_auto_exposure_min_ev(double ev) {
	exposure_meter.limits.least = limited(ev, kDarkest, kBrightest, exposure_meter.limits.least);
	exposure_meter.limits.most = std::max(exposure_meter.limits.most, exposure_meter.limits.least);
}

void BlackHoleSky::set_auto_exposure_max_ev(double ev) {
	exposure_meter.limits.most = limited(ev, kDarkest, kBrightest, exposure_meter.limits.most);
	exposure_meter.limits.least = std::min(exposure_meter.limits.least, exposure_meter.limits.most);
}

void BlackHoleSky::set_adaptation_speed(double factor) {
	exposure_meter.speed = limited(factor, 0.0, 1000.0, exposure_meter.speed);
}

double BlackHoleSky::get_effective_exposure() const {
	return std::clamp(exposure + (is_metering() ? exposure_meter.ev() : 0.0), kDarkest, kBrightest);
}

void BlackHoleSky::meter(const WatchingEye &eye, double seconds, bool all) {
	SkyLight::Sources sources;
	if (stars_visible && catalogue.is_valid()) {
		sources.stars = &catalogue->table();
		sources.magnitude_limit = magnitude_limit;
	}
	if (background == BACKGROUND_PANORAMA || background == BACKGROUND_CUBEMAP) {
		if (background == BACKGROUND_PANORAMA) {
			sources.panorama = panorama;
		} else {
			sources.cubemap = cubemap;
		}
		sources.panorama_luminance = panorama_luminance;
		sources.panorama_is_light = panorama_is_light;
	}
	// The settings may be those of the last frame, before a table went.
	const bool lensed = settings.lensing && is_lensing();
	const blackhole::LensingTables *tables = lensed ? table->data().get() : nullptr;
	disk_sources.disks.clear();
	disk_sources.tables = table.is_valid() && table->is_ready() ? table->data().get() : nullptr;
	for (const AccretionDisk *disk : disks) {
		if (const auto glowing = disk->metered(hole_scale())) {
			disk_sources.disks.push_back(*glowing);
		}
	}
	const ExposureMeter::View view{settings, tables, eye, sources, disk_sources};
	if (std::isinf(seconds)) {
		exposure_meter.settle(view);
	} else {
		exposure_meter.step(view, seconds, all);
	}
	if (std::abs(get_effective_exposure() - applied_exposure) >= kStep) {
		settings_changed();
	}
}

/// Meters between frames, by what the node and the cameras are set to now.
void BlackHoleSky::meter_now(double seconds) {
	if (!is_metering() || !is_inside_tree()) {
		return;
	}
	const std::vector<WatchingEye> &eyes = eye_tracker.eyes_in(get_world_3d(), render_layers);
	if (eyes.empty()) {
		return;
	}
	apply_settings(); // what has moved since the last frame is not yet known
	meter(eyes.front(), seconds, true);
}

void BlackHoleSky::adapt(double seconds) {
	meter_now(limited(seconds, 0.0, 1e9, 0.0));
}

void BlackHoleSky::adapt_at_once() {
	meter_now(std::numeric_limits<double>::infinity());
}
