// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <vector>

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

/// A copy of these numbers as the engine's array.
inline godot::PackedFloat32Array packed_floats(const std::vector<float> &values) {
	godot::PackedFloat32Array packed;
	packed.resize(static_cast<int64_t>(values.size()));
	std::memcpy(packed.ptrw(), values.data(), values.size() * sizeof(float));
	return packed;
}

/// An RGBA32F texture of width x height texels from 4 width height floats, row-major.
inline godot::Ref<godot::ImageTexture> make_float_texture(
		const std::vector<float> &texels, int width, int height) {
	godot::PackedByteArray bytes;
	bytes.resize(static_cast<int64_t>(texels.size() * sizeof(float)));
	std::memcpy(bytes.ptrw(), texels.data(), texels.size() * sizeof(float));
	return godot::ImageTexture::create_from_image(
			godot::Image::create_from_data(width, height, false, godot::Image::FORMAT_RGBAF, bytes));
}
