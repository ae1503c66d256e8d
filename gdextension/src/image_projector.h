// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/tables/lensing_tables.h"
#include "src/sky_settings.h"

/// Where the sky's shaders draw a star's image in a camera's viewport: pixels from its top left corner;
/// nothing when it is not in front of the camera or not on the map. `tables` null: without a hole.
/// `direction`: sky axes, any length.
std::optional<godot::Vector2> project_image(const SkySettings &settings,
		const blackhole::LensingTables *tables, const godot::Camera3D *camera,
		const godot::Vector3 &direction, int order);
