// SPDX-License-Identifier: MIT
#include "core/culling/shift_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blackhole {

ShiftBound::ShiftBound(double coolest_k, double hottest_k, const PlanckTable &planck, double usual) {
	std::array<double, kSteps + 1> exact{};
	for (std::size_t i = 0; i <= kSteps; ++i) {
		const double g = std::exp(kRange * (2.0 * static_cast<double>(i) / kSteps - 1.0));
		// Blueshift brightens cool bodies most, redshift dims hot ones least.
		exact[i] = std::max(planck.log2_luminance(g * coolest_k) - planck.log2_luminance(usual * coolest_k),
				planck.log2_luminance(g * hottest_k) - planck.log2_luminance(usual * hottest_k));
	}
	// A chord lies below a concave curve by at most an eighth of the second difference.
	const auto sag = [&exact](std::size_t i) {
		return std::abs(exact[i - 1] - 2.0 * exact[i] + exact[i + 1]) / 8.0;
	};
	for (std::size_t i = 0; i <= kSteps; ++i) {
		const std::size_t middle = std::clamp<std::size_t>(i, 2, kSteps - 2);
		const double reserve = std::max({sag(middle - 1), sag(middle), sag(middle + 1)});
		gains[i] = static_cast<float>(exact[i] + 1.25 * reserve + 1e-4);
	}
}

double ShiftBound::log2_gain(double ln_g) const {
	const double at = (ln_g / kRange + 1.0) * (0.5 * kSteps);
	if (!(at < kSteps)) {
		return std::numeric_limits<double>::infinity();
	}
	const auto left = static_cast<std::size_t>(std::max(at, 0.0));
	const double part = std::max(at - static_cast<double>(left), 0.0);
	return std::lerp(double{gains[left]}, double{gains[left + 1]}, part);
}

} // namespace blackhole
