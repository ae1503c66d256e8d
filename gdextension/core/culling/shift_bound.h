// SPDX-License-Identifier: MIT
#pragma once

#include "core/photometry/planck_table.h"

#include <array>
#include <cstddef>

namespace blackhole {

/// How much brighter a shift of all frequencies can make the surface of any of several black bodies, compared
/// with a usual shift, quickly.
class ShiftBound {
public:
	ShiftBound() = default;
	/// For temperatures between these two, kelvin; `usual` is the frequency ratio to compare with.
	ShiftBound(double coolest_k, double hottest_k, const PlanckTable &planck, double usual = 1.0);

	/// At least the largest log2 of Y(g T)/Y(usual T), and hardly above it for ln g within +-2;
	/// +infinity for g beyond e^4.
	[[nodiscard]] double log2_gain(double ln_g) const;

private:
	static constexpr std::size_t kSteps = 64;
	static constexpr double kRange = 4.0; ///< of |ln g|
	std::array<float, kSteps + 1> gains{};
};

} // namespace blackhole
