// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/aabb.hpp>

/// Render priorities of the sky's layers, behind everything else that is transparent: the background first,
/// the stars added to it, disks over both.
inline constexpr int kBackgroundPriority = -110;
inline constexpr int kStarPriority = -100; ///< and one more for each order of images
inline constexpr int kDiskPriority = -90;
inline constexpr int kRingPriority = -89; ///< rings on a disk are drawn over it

/// The box of what no camera may leave out.
inline godot::AABB everywhere() {
	constexpr float kFar = 1e6F;
	return {godot::Vector3(-kFar, -kFar, -kFar), godot::Vector3(2, 2, 2) * kFar};
}
