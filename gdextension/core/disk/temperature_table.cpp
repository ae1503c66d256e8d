// SPDX-License-Identifier: MIT
#include "core/disk/temperature_table.h"

#include "core/disk/page_thorne.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace blackhole {
namespace {

/// The factor at s = sqrt(3/r); near either end that of a place beside it, to which it tends.
double factor(double s) {
	const double at = std::clamp(s, 1e-4, 1.0 - 1e-6);
	return page_thorne_temperature(kInnermostStable / (at * at)) / (at * std::sqrt(at * (1.0 - at)));
}

} // namespace

std::vector<float> bake_temperature_table() {
	std::vector<float> texels(std::size_t{4} * kTemperatureTableSize, 0.0F);
	for (int i = 0; i < kTemperatureTableSize; ++i) {
		const double s = i / (kTemperatureTableSize - 1.0);
		texels[std::size_t{4} * static_cast<std::size_t>(i)] = static_cast<float>(factor(s));
	}
	return texels;
}

} // namespace blackhole
