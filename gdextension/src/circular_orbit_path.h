// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/relativity/circular_orbit.h"

/// A circular orbit in free fall, exact at every proper time.
class CircularOrbitPath : public godot::RefCounted {
	GDCLASS(CircularOrbitPath, godot::RefCounted)

	std::optional<blackhole::CircularOrbit> orbit;
	godot::String error_message;

protected:
	static void _bind_methods();

public:
	godot::Error start(const godot::Vector3 &position, const godot::Vector3 &axis);
	bool is_ready() const { return orbit.has_value(); }
	godot::String get_error_message() const { return error_message; }

	double get_radius() const;
	godot::Vector3 get_axis() const;
	bool is_stable() const { return orbit && orbit->is_stable(); }
	double get_energy() const;
	double get_period() const;
	double get_rain_period() const;

	godot::Vector3 position_at(double proper_time) const;
	godot::Vector3 celerity_at(double proper_time) const;
	double rain_time_at(double proper_time) const;
	double far_clock_rate_at(double proper_time, const godot::Vector3 &view_direction) const;
};
