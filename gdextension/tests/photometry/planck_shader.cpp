// SPDX-License-Identifier: MIT
#include "tests/photometry/planck_shader.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>

namespace blackhole::shader {

namespace {

using namespace glm;

struct sampler2D {
	const std::vector<float> &texels;
};

vec4 texelFetch(sampler2D p_sampler, ivec2 p_place, int /*p_lod*/) {
	const auto at = 4 * static_cast<std::size_t>(p_place.x);
	// .at() throws, and so fails the test, when the shader reads outside the table.
	return {p_sampler.texels.at(at), p_sampler.texels.at(at + 1), p_sampler.texels.at(at + 2),
			p_sampler.texels.at(at + 3)};
}

#include "../addons/blackhole_sky/shaders/planck.gdshaderinc"

float shifted_limit(float p_temperature, float p_g) {
	return planck_shifted_limit(p_temperature, p_g);
}

} // namespace

glm::vec4 planck_light(const std::vector<float> &p_texels, float p_temperature) {
	return planck_light(sampler2D{p_texels}, p_temperature);
}

glm::vec4 planck_shifted(const std::vector<float> &p_texels, float p_temperature, float p_g) {
	return planck_shifted(sampler2D{p_texels}, p_temperature, p_g);
}

float planck_shifted_limit(float p_temperature, float p_g) {
	return shifted_limit(p_temperature, p_g);
}

} // namespace blackhole::shader
