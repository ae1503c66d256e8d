// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/rid.hpp>

/// A black cube map, made at first use and shared by all nodes, for samplers that have none of their own.
/// Left without one they make the Compatibility renderer of Godot 4.6 set the filter of whatever 2D texture
/// was bound before, which is unreadable from then on: all that is drawn with it is black.
godot::RID empty_cubemap();

/// Lets go of it before the engine shuts its renderer down.
void release_empty_cubemap();
