// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace blackhole {

/// Texels of the temperature table: a texture this wide and 1 high, RGBA, 32-bit floats (the first channel
/// counts).
inline constexpr int kTemperatureTableSize = 128;

/// The smooth factor of the temperature of the disk of Page and Thorne, as
/// addons/blackhole_sky/shaders/disk_gas.gdshaderinc reads it: texel i at s = i/(size - 1), s = sqrt(3/r),
/// holds T/T_max over s^(3/2) sqrt(1 - s). Linear interpolation leaves a relative error of 2.2e-5.
std::vector<float> bake_temperature_table();

} // namespace blackhole
