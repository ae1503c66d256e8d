// SPDX-License-Identifier: MIT
#include "src/black_body.h"

#include <limits>
#include <numbers>

#include <godot_cpp/variant/utility_functions.hpp>

#include "core/photometry/planck.h"
#include "core/photometry/planck_table.h"
#include "src/float_texture.h"
#include "src/glm_adapter.h"
#include "src/planck_texture.h"

using namespace godot;

namespace {

constexpr double kCoolest = 10.0; // kelvin; core integrates from here on

bool is_warm_enough(const char *caller, double kelvin) {
	if (kelvin >= kCoolest) {
		return true;
	}
	UtilityFunctions::push_error(String("BlackBody.") + caller + ": the temperature must be 10 K or more.");
	return false;
}

} // namespace

Vector3 BlackBody::colour(double kelvin) {
	return is_warm_enough("colour", kelvin) ? to_godot(blackhole::planck_rgb(kelvin)) : Vector3();
}

double BlackBody::log2_luminance(double kelvin) {
	return is_warm_enough("log2_luminance", kelvin)
			? blackhole::planck_light(kelvin).ln_luminance * std::numbers::log2e
			: std::numeric_limits<double>::quiet_NaN();
}

Ref<ImageTexture> BlackBody::get_texture() {
	return planck_texture();
}

PackedFloat32Array BlackBody::get_texels() {
	return packed_floats(blackhole::bake_planck_table());
}

void BlackBody::_bind_methods() {
	ClassDB::bind_static_method("BlackBody", D_METHOD("colour", "kelvin"), &BlackBody::colour);
	ClassDB::bind_static_method(
			"BlackBody", D_METHOD("log2_luminance", "kelvin"), &BlackBody::log2_luminance);
	ClassDB::bind_static_method("BlackBody", D_METHOD("get_texture"), &BlackBody::get_texture);
	ClassDB::bind_static_method("BlackBody", D_METHOD("get_texels"), &BlackBody::get_texels);
}
