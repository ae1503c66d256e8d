// SPDX-License-Identifier: MIT
#include "src/radial_fall_path.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include <godot_cpp/variant/utility_functions.hpp>

#include "core/relativity/clocks.h"
#include "core/relativity/not_a_number.h"
#include "src/glm_adapter.h"

using namespace godot;

namespace {

/// Where a ride stays when it is asked for times at or after the end.
constexpr double kLastRadius = 1e-6;

Vector3 along(const Vector3 &outward, double length) {
	const glm::dvec3 direction = to_glm(outward);
	const double size = glm::length(direction);
	return size > 0.0 ? to_godot(direction * (length / size)) : Vector3();
}

} // namespace

Error RadialFallPath::take(
		const blackhole::Outcome<blackhole::RadialFall> &fall, double radius, bool outward) {
	using Path = blackhole::Outcome<blackhole::RadialPath>;
	const blackhole::RadialWay way = outward ? blackhole::RadialWay::kOutward : blackhole::RadialWay::kInward;
	const Path made =
			fall ? blackhole::RadialPath::start(*fall.value, radius, way) : Path::failure(fall.error);
	if (!made) {
		error_message = "RadialFallPath: " + String::utf8(made.error.c_str()) + ".";
		UtilityFunctions::push_error(error_message);
		return ERR_INVALID_PARAMETER;
	}
	path = made.value;
	last_time = path->proper_time_to(std::min(kLastRadius, radius)).value.value_or(path->duration());
	error_message = String();
	return OK;
}

Error RadialFallPath::start_with_energy(double radius, double energy, bool outward) {
	return take(blackhole::RadialFall::with_energy(energy), radius, outward);
}

Error RadialFallPath::start_from_rest(double radius) {
	return take(blackhole::RadialFall::from_rest(radius), radius, false);
}

double RadialFallPath::get_energy() const {
	return path ? path->fall().energy() : blackhole::kNaN;
}

double RadialFallPath::get_start_radius() const {
	return path ? path->start_radius() : blackhole::kNaN;
}

double RadialFallPath::get_highest_radius() const {
	return path ? path->fall().highest_radius() : blackhole::kNaN;
}

double RadialFallPath::get_duration() const {
	return path ? path->duration() : blackhole::kNaN;
}

double RadialFallPath::proper_time_to(double radius) const {
	return path ? path->proper_time_to(radius).value.value_or(blackhole::kNaN) : blackhole::kNaN;
}

std::optional<blackhole::RadialMoment> RadialFallPath::moment(double proper_time) const {
	if (!path) {
		return std::nullopt;
	}
	return path->at(std::clamp(proper_time, 0.0, last_time)).value;
}

double RadialFallPath::radius_at(double proper_time) const {
	const auto now = moment(proper_time);
	return now ? now->radius : blackhole::kNaN;
}

bool RadialFallPath::is_outward_at(double proper_time) const {
	const auto now = moment(proper_time);
	return now && now->way == blackhole::RadialWay::kOutward;
}

double RadialFallPath::rain_time_at(double proper_time) const {
	const auto now = moment(proper_time);
	return now ? now->rain_time : blackhole::kNaN;
}

double RadialFallPath::radial_celerity_at(double proper_time) const {
	const auto now = moment(proper_time);
	return now ? now->celerity : blackhole::kNaN;
}

double RadialFallPath::far_clock_rate_at(double proper_time) const {
	const auto now = moment(proper_time);
	if (!now) {
		return blackhole::kNaN;
	}
	const glm::dvec3 outward(1.0, 0.0, 0.0);
	return blackhole::far_clock_rate_outward(now->radius * outward, now->celerity * outward)
			.value.value_or(blackhole::kNaN);
}

Vector3 RadialFallPath::position_at(double proper_time, const Vector3 &outward) const {
	const auto now = moment(proper_time);
	return now ? along(outward, now->radius) : Vector3();
}

Vector3 RadialFallPath::celerity_at(double proper_time, const Vector3 &outward) const {
	const auto now = moment(proper_time);
	return now ? along(outward, now->celerity) : Vector3();
}

void RadialFallPath::_bind_methods() {
	ClassDB::bind_method(D_METHOD("start_with_energy", "radius", "energy", "outward"),
			&RadialFallPath::start_with_energy, DEFVAL(false));
	ClassDB::bind_method(D_METHOD("start_from_rest", "radius"), &RadialFallPath::start_from_rest);
	ClassDB::bind_method(D_METHOD("is_ready"), &RadialFallPath::is_ready);
	ClassDB::bind_method(D_METHOD("get_error_message"), &RadialFallPath::get_error_message);
	ClassDB::bind_method(D_METHOD("get_energy"), &RadialFallPath::get_energy);
	ClassDB::bind_method(D_METHOD("get_start_radius"), &RadialFallPath::get_start_radius);
	ClassDB::bind_method(D_METHOD("get_highest_radius"), &RadialFallPath::get_highest_radius);
	ClassDB::bind_method(D_METHOD("get_duration"), &RadialFallPath::get_duration);
	ClassDB::bind_method(D_METHOD("proper_time_to", "radius"), &RadialFallPath::proper_time_to);
	ClassDB::bind_method(D_METHOD("radius_at", "proper_time"), &RadialFallPath::radius_at);
	ClassDB::bind_method(D_METHOD("is_outward_at", "proper_time"), &RadialFallPath::is_outward_at);
	ClassDB::bind_method(D_METHOD("rain_time_at", "proper_time"), &RadialFallPath::rain_time_at);
	ClassDB::bind_method(D_METHOD("radial_celerity_at", "proper_time"), &RadialFallPath::radial_celerity_at);
	ClassDB::bind_method(D_METHOD("far_clock_rate_at", "proper_time"), &RadialFallPath::far_clock_rate_at);
	ClassDB::bind_method(D_METHOD("position_at", "proper_time", "outward"), &RadialFallPath::position_at);
	ClassDB::bind_method(D_METHOD("celerity_at", "proper_time", "outward"), &RadialFallPath::celerity_at);
}
