// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/outcome.h"
#include "core/relativity/world_line.h"

/// An observer with a rocket: the true world line under a thrust given from frame to frame.
class PilotedObserver : public godot::RefCounted {
	GDCLASS(PilotedObserver, godot::RefCounted)

	std::optional<blackhole::WorldLine> line;
	godot::String error_message;

	godot::Error take(const blackhole::Outcome<blackhole::WorldLine> &made);

protected:
	static void _bind_methods();

public:
	/// blackhole::WorldLineEnd for scripts.
	enum Progress : int {
		PROGRESS_ON_THE_WAY = 0,
		PROGRESS_CENTRE = 1,
		PROGRESS_TOO_FAST = 2,
		PROGRESS_REFUSED = 3,
	};

	godot::Error start(const godot::Vector3 &position, const godot::Vector3 &celerity);
	godot::Error start_static(const godot::Vector3 &position);
	Progress advance(double duration, const godot::Vector3 &thrust);
	bool is_ready() const { return line.has_value(); }
	godot::String get_error_message() const { return error_message; }

	godot::Vector3 get_position() const;
	godot::Vector3 get_celerity() const;
	double get_radius() const;
	double get_proper_time() const;
	double get_rain_time() const;
	double get_energy() const;
	godot::Vector3 get_angular_momentum() const;
	double far_clock_rate(const godot::Vector3 &view_direction) const;
};

VARIANT_ENUM_CAST(PilotedObserver::Progress);
