// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/ref.hpp>

/// The Planck light table as a texture (RGBA32F, one row), baked at first use and shared by all nodes.
godot::Ref<godot::ImageTexture> planck_texture();

/// Lets go of the shared texture before the engine shuts its renderer down.
void release_planck_texture();
