// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/ref.hpp>

#include "core/photometry/point_spread.h"

/// The table of a point spread as a texture (RGBA32F) for star_profile.gdshaderinc; glare: see
/// PointSpreadTable.
godot::Ref<godot::ImageTexture> make_profile_texture(blackhole::PointSpread model, double glare);
