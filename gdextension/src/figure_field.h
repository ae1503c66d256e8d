// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

/// Makes the cube map by which BlackHoleSky draws line figures on the sky, sharp at every magnification.
class FigureField : public godot::RefCounted {
	GDCLASS(FigureField, godot::RefCounted)

protected:
	static void _bind_methods();

public:
	static godot::TypedArray<godot::Image> bake(const godot::PackedVector3Array &segments, int size);
};
