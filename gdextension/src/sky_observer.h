// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/relativity/observer_field.h"
#include "src/lensing_table.h"

/// How observers move at every place round a hole, and what they see there by the exact solution.
class SkyObserver : public godot::Resource {
	GDCLASS(SkyObserver, godot::Resource)

	LensingTable::Motion motion = LensingTable::MOTION_STATIC;
	double energy = 1.0;
	bool outgoing = false;
	godot::Vector3 axis{0, 1, 0};
	godot::Vector3 celerity;
	bool relative_to_static = false;

protected:
	static void _bind_methods();

public:
	void set_motion(LensingTable::Motion p_motion);
	LensingTable::Motion get_motion() const { return motion; }
	void set_energy(double p_energy);
	double get_energy() const { return energy; }
	void set_outgoing(bool p_outgoing);
	bool is_outgoing() const { return outgoing; }
	void set_axis(const godot::Vector3 &p_axis);
	godot::Vector3 get_axis() const { return axis; }
	void set_celerity(const godot::Vector3 &p_celerity);
	godot::Vector3 get_celerity() const { return celerity; }
	void set_relative_to_static(bool p_relative);
	bool is_relative_to_static() const { return relative_to_static; }

	static double energy_from_rest(double radius);
	static godot::Vector3 celerity_from_velocity(const godot::Vector3 &velocity);

	godot::String get_refusal(const godot::Vector3 &position) const;
	godot::Vector3 celerity_at(const godot::Vector3 &position) const;
	godot::Dictionary shadow(const godot::Vector3 &position) const;
	godot::Dictionary star_image(const godot::Vector3 &position, const godot::Vector3 &star, int order) const;
	godot::Dictionary trace(const godot::Vector3 &position, const godot::Vector3 &view_direction) const;
	godot::Dictionary disk_point(const godot::Vector3 &position, const godot::Vector3 &view_direction,
			const godot::Vector3 &normal, int order, bool retrograde) const;
	godot::Dictionary plane_crossing(const godot::Vector3 &place, const godot::Vector3 &direction,
			const godot::Vector3 &normal, int order) const;

	/// The same for core.
	blackhole::ObserverField field() const;
};
