// SPDX-License-Identifier: MIT
#include "src/figure_field.h"

#include <cstring>
#include <vector>

#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include "core/overlay/figure_field.h"
#include "src/glm_adapter.h"

using namespace godot;

TypedArray<Image> FigureField::bake(const PackedVector3Array &segments, int size) {
	TypedArray<Image> faces;
	if (segments.size() % 2 != 0) {
		UtilityFunctions::push_error(
				"FigureField.bake: segments are pairs of directions; one end is missing.");
		return faces;
	}
	std::vector<blackhole::SkySegment> lines;
	lines.reserve(static_cast<std::size_t>(segments.size() / 2));
	for (int64_t i = 0; i + 1 < segments.size(); i += 2) {
		lines.push_back({to_glm(segments[i]), to_glm(segments[i + 1])});
	}
	const auto field = blackhole::bake_figure_field(lines, size);
	if (!field) {
		UtilityFunctions::push_error("FigureField.bake: " + String::utf8(field.error.c_str()));
		return faces;
	}
	const std::size_t texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
	for (std::size_t face = 0; face < 6; ++face) {
		PackedByteArray bytes;
		bytes.resize(static_cast<int64_t>(4 * sizeof(float) * texels));
		std::memcpy(bytes.ptrw(), field.value->texels.data() + 4 * face * texels, 4 * sizeof(float) * texels);
		const Ref<Image> image = Image::create_from_data(size, size, false, Image::FORMAT_RGBAF, bytes);
		image->convert(Image::FORMAT_RGBAH);
		faces.push_back(image);
	}
	return faces;
}

void FigureField::_bind_methods() {
	ClassDB::bind_static_method(
			"FigureField", D_METHOD("bake", "segments", "size"), &FigureField::bake, DEFVAL(512));
}
