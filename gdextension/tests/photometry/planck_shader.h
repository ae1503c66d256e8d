// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec4.hpp>

namespace blackhole::shader {

/// addons/blackhole_sky/shaders/planck.gdshaderinc, compiled as C++ in single precision; p_texels as baked.
glm::vec4 planck_light(const std::vector<float> &p_texels, float p_temperature);
glm::vec4 planck_shifted(const std::vector<float> &p_texels, float p_temperature, float p_g);
float planck_shifted_limit(float p_temperature, float p_g);

} // namespace blackhole::shader
