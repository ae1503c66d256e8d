// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/outcome.h"
#include "core/relativity/radial_path.h"

/// A fall along a radius, exact at every proper time: what a ride scrubs through.
class RadialFallPath : public godot::RefCounted {
	GDCLASS(RadialFallPath, godot::RefCounted)

	std::optional<blackhole::RadialPath> path;
	double last_time = 0.0;
	godot::String error_message;

	godot::Error take(const blackhole::Outcome<blackhole::RadialFall> &fall, double radius, bool outward);
	std::optional<blackhole::RadialMoment> moment(double proper_time) const;

protected:
	static void _bind_methods();

public:
	godot::Error start_with_energy(double radius, double energy, bool outward);
	godot::Error start_from_rest(double radius);
	bool is_ready() const { return path.has_value(); }
	godot::String get_error_message() const { return error_message; }

	double get_energy() const;
	double get_start_radius() const;
	double get_highest_radius() const;
	double get_duration() const;
	double proper_time_to(double radius) const;

	double radius_at(double proper_time) const;
	bool is_outward_at(double proper_time) const;
	double rain_time_at(double proper_time) const;
	double radial_celerity_at(double proper_time) const;
	double far_clock_rate_at(double proper_time) const;
	godot::Vector3 position_at(double proper_time, const godot::Vector3 &outward) const;
	godot::Vector3 celerity_at(double proper_time, const godot::Vector3 &outward) const;
};
