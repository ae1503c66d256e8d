// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/disk/disk_point.h"
#include "core/relativity/observer_field.h"
#include "src/lensing_table.h"

/// The motion as core names it.
blackhole::ObserverMotion core_motion(LensingTable::Motion motion);

/// The exact solution as dictionaries (see the class reference of SkyObserver); empty, with an error that
/// names `caller`, where there is no such observer.
godot::Dictionary exact_star_image(const char *caller, const godot::Vector3 &position,
		const godot::Vector3 &star, int order, const blackhole::ObserverField &observer);
godot::Dictionary exact_trace(const char *caller, const godot::Vector3 &position,
		const godot::Vector3 &view_direction, const blackhole::ObserverField &observer);
godot::Dictionary exact_disk_point(const char *caller, const godot::Vector3 &position,
		const godot::Vector3 &view_direction, const blackhole::DiskPlane &plane, int order,
		const blackhole::ObserverField &observer);
godot::Dictionary exact_plane_crossing(const char *caller, const godot::Vector3 &position,
		const godot::Vector3 &view_direction, const godot::Vector3 &normal, int order,
		const blackhole::ObserverField &observer);
