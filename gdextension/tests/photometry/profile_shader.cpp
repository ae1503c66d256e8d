// SPDX-License-Identifier: MIT
#include "tests/photometry/profile_shader.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace blackhole::shader {

namespace {

using namespace glm;

struct sampler2D {
	const std::vector<float> &texels;
};

vec4 texelFetch(sampler2D p_sampler, ivec2 p_place, int /*p_lod*/) {
	const auto at = 4 * (512 * static_cast<std::size_t>(p_place.y) + static_cast<std::size_t>(p_place.x));
	// .at() throws, and so fails the test, when the shader reads outside the table.
	return {p_sampler.texels.at(at), p_sampler.texels.at(at + 1), p_sampler.texels.at(at + 2),
			p_sampler.texels.at(at + 3)};
}

namespace included {
#include "../addons/blackhole_sky/shaders/star_profile.gdshaderinc"
} // namespace included

} // namespace

float profile_light(const std::vector<float> &p_texels, float p_t, float p_ratio) {
	return included::profile_light(sampler2D{p_texels}, p_t, p_ratio);
}

float profile_faded_light(const std::vector<float> &p_texels, float p_t, float p_ratio) {
	return included::profile_faded_light(sampler2D{p_texels}, p_t, p_ratio);
}

bool profile_is_seen(const std::vector<float> &p_texels, float p_contrast, float p_ratio) {
	return included::profile_is_seen(sampler2D{p_texels}, p_contrast, p_ratio);
}

float profile_cut(const std::vector<float> &p_texels, float p_contrast, float p_ratio) {
	return included::profile_cut(sampler2D{p_texels}, p_contrast, p_ratio);
}

float profile_fade(float p_part) {
	return included::profile_fade(p_part);
}

} // namespace blackhole::shader
