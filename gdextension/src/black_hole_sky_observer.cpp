// SPDX-License-Identifier: MIT
// Who sees the sky of a BlackHoleSky, and what its signals tell of observers and cameras.
#include "src/black_hole_sky.h"

#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include "src/glm_adapter.h"

using namespace godot;

void BlackHoleSky::set_observer_motion(LensingTable::Motion motion) {
	if (observer.is_null() && motion != LensingTable::MOTION_STATIC) {
		Ref<SkyObserver> made;
		made.instantiate();
		set_observer(made);
	}
	if (observer.is_valid()) {
		observer->set_motion(motion);
	}
}

LensingTable::Motion BlackHoleSky::get_observer_motion() const {
	return observer.is_valid() ? observer->get_motion() : LensingTable::MOTION_STATIC;
}

void BlackHoleSky::set_observer(const Ref<SkyObserver> &p_observer) {
	if (p_observer == observer) {
		return;
	}
	const Callable changed = callable_mp(this, &BlackHoleSky::observer_changed);
	if (observer.is_valid() && observer->is_connected("changed", changed)) {
		observer->disconnect("changed", changed);
	}
	observer = p_observer;
	if (observer.is_valid()) {
		observer->connect("changed", changed);
	}
	observer_changed();
}

void BlackHoleSky::observer_changed() {
	settings_changed();
	emit_signal("observer_changed");
}

blackhole::ObserverField BlackHoleSky::observer_field() const {
	return observer.is_valid() ? observer->field() : blackhole::ObserverField();
}

/// Whether the node is still there: who is told may remove it.
bool BlackHoleSky::tell_of_horizon(const std::vector<WatchingEye> &eyes) {
	if (!is_lensing()) {
		horizon_watch.forget();
		return true;
	}
	const glm::dvec3 hole = to_glm(get_global_transform().origin);
	if (!horizon_watch.look(eyes, hole, schwarzschild_radius)) {
		return true;
	}
	const uint64_t own_id = get_instance_id();
	const std::vector<HorizonWatch::Crossing> crossings = horizon_watch.crossings();
	for (const HorizonWatch::Crossing &crossing : crossings) {
		auto *camera = Object::cast_to<Camera3D>(ObjectDB::get_instance(crossing.camera));
		if (camera != nullptr) {
			emit_signal("horizon_crossed", crossing.inward, camera);
		}
		if (ObjectDB::get_instance(own_id) == nullptr || !is_inside_tree()) {
			return false;
		}
	}
	return true;
}
