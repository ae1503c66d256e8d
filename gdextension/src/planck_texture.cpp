// SPDX-License-Identifier: MIT
#include "src/planck_texture.h"

#include "core/photometry/planck_table.h"
#include "src/float_texture.h"

namespace {

godot::Ref<godot::ImageTexture> &shared_texture() {
	static godot::Ref<godot::ImageTexture> texture;
	return texture;
}

} // namespace

godot::Ref<godot::ImageTexture> planck_texture() {
	godot::Ref<godot::ImageTexture> &texture = shared_texture();
	if (texture.is_null()) {
		texture = make_float_texture(
				blackhole::bake_planck_table(), static_cast<int>(blackhole::kPlanckTableSize), 1);
	}
	return texture;
}

void release_planck_texture() {
	shared_texture().unref();
}
