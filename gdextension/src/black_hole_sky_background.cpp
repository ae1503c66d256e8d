// SPDX-License-Identifier: MIT
// What a BlackHoleSky shows behind the stars: a panorama, a cube map or the surroundings.
#include "src/black_hole_sky.h"

#include <algorithm>

#include "src/property_limits.h"

using namespace godot;

void BlackHoleSky::apply_background() {
	BackgroundPictures pictures;
	pictures.panorama = panorama.is_valid() ? panorama->get_rid() : RID();
	pictures.cubemap = cubemap.is_valid() ? cubemap->get_rid() : RID();
	pictures.surroundings = surroundings.is_valid() ? surroundings->get_rid() : RID();
	background_layer.set_source(background, pictures, panorama_luminance);
}

void BlackHoleSky::set_background(Background kind) {
	background = std::clamp(kind, BACKGROUND_NONE, BACKGROUND_SURROUNDINGS);
	apply_background();
	settings_changed(); // the exposure may be metered or not
	update_configuration_warnings();
}

void BlackHoleSky::set_panorama(const Ref<Texture2D> &texture) {
	panorama = texture;
	apply_background();
	update_configuration_warnings();
}

void BlackHoleSky::set_cubemap(const Ref<Cubemap> &texture) {
	cubemap = texture;
	apply_background();
	update_configuration_warnings();
}

void BlackHoleSky::set_surroundings(const Ref<Texture2D> &texture) {
	surroundings = texture;
	apply_background();
	update_configuration_warnings();
}

void BlackHoleSky::set_panorama_luminance(double luminance) {
	panorama_luminance = limited(luminance, 0.0, 1e30, panorama_luminance);
	apply_background();
}

void BlackHoleSky::set_panorama_is_light(bool is_light) {
	panorama_is_light = is_light;
	background_layer.set_panorama_is_light(is_light);
}
