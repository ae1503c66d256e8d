// SPDX-License-Identifier: MIT
#pragma once

#include "core/photometry/planck_table.h"

#include <array>
#include <cstddef>

namespace blackhole {

/// How much brighter a shift of all frequencies can make the surface of any of several black bodies, quickly.
class ShiftBound {
public:
	ShiftBound() = default;
	/// For temperatures between these two, kelvin.
	ShiftBound(double coolest_k, double hottest_k, const PlanckTable &planck);

	/// At least the largest log2 of Y(g T)/Y(T), and never much more than 0.1 above it for ln g within +-2;
	/// +infinity for g beyond e^4.
	[[nodiscard]] double log2_gain(double ln_g) const;

private:
	static constexpr std::size_t kSteps = 64;
	static constexpr double kRange = 4.0; ///< of |ln g|
	std::array<float, kSteps + 1> gains{};
};

} // namespace blackhole
