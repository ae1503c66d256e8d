// SPDX-License-Identifier: MIT
#include "src/exposure_meter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "core/relativity/observer.h"
#include "core/tables/shader_lensing.h"
#include "src/glm_adapter.h"

using namespace godot;

namespace {

/// In which all directions are metered anew: 12 a frame at 60 frames a second.
constexpr double kRoundSeconds = 0.2;
constexpr double kFewest = 4.0; // directions a frame

/// Where a line of sight ends.
struct Sight {
	bool captured = false;
	glm::dvec3 sky{0.0}; ///< unit vector, world axes
	double shift = 1.0;  ///< of frequencies
};

/// From the axis to the picture's corners, radians; maps show the whole sky or a part round the axis.
double half_angle(const SkySettings &settings, const WatchingEye &eye) {
	constexpr int kFisheye180 = 4; // BlackHoleSky::Projection
	constexpr int kFisheye220 = 5;
	if (settings.projection == kFisheye180 || settings.projection == kFisheye220) {
		return (settings.projection == kFisheye180 ? 90.0 : 110.0) * std::numbers::pi / 180.0;
	}
	// A headset looks everywhere.
	const bool whole = settings.projection != 0 || eye.axis == glm::dvec3(0.0);
	return whole ? std::numbers::pi : std::acos(std::clamp(eye.corner_cosine, -1.0, 1.0));
}

/// A rotation that carries the z axis to the viewing axis.
glm::dmat3 axes(const WatchingEye &eye) {
	const glm::dvec3 z = eye.axis == glm::dvec3(0.0) ? glm::dvec3(0.0, 0.0, 1.0) : glm::normalize(eye.axis);
	const glm::dvec3 aside = std::abs(z.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
	const glm::dvec3 x = glm::normalize(glm::cross(aside, z));
	return {x, glm::cross(z, x), z};
}

/// Without a hole only a given velocity changes the sky.
Sight straight(const SkySettings &settings, const glm::dvec3 &direction) {
	Sight sight;
	sight.sky = direction;
	if (settings.observer.motion != blackhole::ObserverMotion::kVelocity) {
		return sight;
	}
	const glm::dvec3 celerity = settings.observer.celerity;
	if ((settings.effects & lensing_shader::kAberration) != 0) {
		sight.sky = blackhole::boost_direction(direction, -celerity);
	}
	if ((settings.effects & lensing_shader::kDoppler) != 0) {
		sight.shift = blackhole::doppler_factor(sight.sky, celerity);
	}
	return sight;
}

Sight lensed(const SkySettings &settings, const blackhole::LensingTables &tables, const glm::dvec3 &place,
		const glm::dvec3 &direction) {
	const auto seen = blackhole::ShaderLensing(tables).trace(
			glm::vec3(place), glm::vec3(direction), settings.observer, settings.effects);
	return {seen.captured, glm::dvec3(seen.direction), double{seen.redshift}};
}

} // namespace

void ExposureMeter::begin_from(double ev) {
	adaptation.settle(ev);
	begun = true;
}

void ExposureMeter::measure(const View &view, std::size_t directions) {
	light.use(view.sources);
	const SkySettings &settings = view.settings;
	const glm::dvec3 place = place_in_radii(settings, view.eye.place);
	const glm::dvec3 disk_place = place_in_radii(view.disks.settings, view.eye.place);
	const glm::dmat3 to_world = axes(view.eye);
	const double reach = half_angle(settings, view.eye);
	const Basis to_sky = settings.sky_to_world.transposed();
	for (std::size_t i = 0; i < directions; ++i) {
		const std::size_t number = meter.next();
		const glm::dvec3 direction = to_world * blackhole::LightMeter::direction(number, reach);
		const Sight sight = view.tables != nullptr ? lensed(settings, *view.tables, place, direction)
												   : straight(settings, direction);
		const glm::dvec3 sky = to_glm(to_sky.xform(to_godot(sight.sky)));
		const double behind = sight.captured ? 0.0 : light.luminance(sky, sight.shift);
		meter.set_luminance(number, before(view.disks, disk_place, direction, behind));
	}
}

double ExposureMeter::before(
		const DiskSources &disks, const glm::dvec3 &place, const glm::dvec3 &direction, double behind) {
	if (disks.disks.empty() || disks.tables == nullptr) {
		return behind;
	}
	if (planck == nullptr) {
		planck = std::make_unique<blackhole::PlanckTable>();
	}
	double sum = 0.0;
	double through = 1.0;
	for (const blackhole::GlowingDisk &disk : disks.disks) {
		const blackhole::DiskGlow glow =
				blackhole::disk_glow(*disks.tables, *planck, disk, place, direction, disks.settings.observer);
		sum += through * glow.luminance;
		through *= glow.through;
	}
	return sum + through * behind;
}

void ExposureMeter::step(const View &view, double seconds, bool all) {
	if (!begun) {
		settle(view);
		return;
	}
	constexpr double kAll = blackhole::LightMeter::kDirections;
	const double share = std::clamp(kAll * seconds / kRoundSeconds, kFewest, kAll);
	measure(view, static_cast<std::size_t>(metered && !all ? std::ceil(share) : kAll));
	metered = true;
	adaptation.step(blackhole::wanted_exposure(meter.mean(), limits), seconds, speed);
}

void ExposureMeter::settle(const View &view) {
	measure(view, blackhole::LightMeter::kDirections);
	metered = true;
	begin_from(blackhole::wanted_exposure(meter.mean(), limits));
}
