// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace blackhole::shader {

/// addons/blackhole_sky/shaders/star_profile.gdshaderinc, compiled as C++ in single precision; p_texels as
/// PointSpreadTable::texels() gives them.
float profile_light(const std::vector<float> &p_texels, float p_t, float p_ratio);
float profile_faded_light(const std::vector<float> &p_texels, float p_t, float p_ratio);
bool profile_is_seen(const std::vector<float> &p_texels, float p_contrast, float p_ratio);
float profile_cut(const std::vector<float> &p_texels, float p_contrast, float p_ratio);
float profile_fade(float p_part);

} // namespace blackhole::shader
