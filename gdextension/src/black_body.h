// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/vector3.hpp>

/// Colour and luminance of black bodies, and the table from which the shaders read them.
class BlackBody : public godot::RefCounted {
	GDCLASS(BlackBody, godot::RefCounted)

protected:
	static void _bind_methods();

public:
	static godot::Vector3 colour(double kelvin);
	static double log2_luminance(double kelvin);
	static godot::Ref<godot::ImageTexture> get_texture();
	static godot::PackedFloat32Array get_texels();
};
