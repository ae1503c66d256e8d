// SPDX-License-Identifier: MIT
#include "src/empty_cubemap.h"

#include <godot_cpp/classes/cubemap.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

using namespace godot;

namespace {

Ref<Cubemap> &shared_cubemap() {
	static Ref<Cubemap> cubemap;
	return cubemap;
}

} // namespace

RID empty_cubemap() {
	Ref<Cubemap> &cubemap = shared_cubemap();
	if (cubemap.is_null()) {
		PackedByteArray black;
		black.resize(4);
		black.fill(0);
		TypedArray<Image> faces;
		for (int face = 0; face < 6; ++face) {
			faces.push_back(Image::create_from_data(1, 1, false, Image::FORMAT_RGBA8, black));
		}
		cubemap.instantiate();
		cubemap->create_from_images(faces);
	}
	return cubemap->get_rid();
}

void release_empty_cubemap() {
	shared_cubemap().unref();
}
