// SPDX-License-Identifier: MIT
#pragma once

#include "core/culling/star_groups.h"
#include "core/relativity/observer_field.h"
#include "core/tables/lensing_tables.h"

#include <array>
#include <cstddef>
#include <functional>

#include <glm/vec3.hpp>

namespace blackhole {

/// The observer at an eye, as the shader takes it: where the motion does not exist, the nearest that does
/// (the static observer above a fall's turning point, else rain). position: of the eye from the hole in r_s,
/// not zero; it and the observer's vectors in the axes of the star groups.
LocalObserver drawn_observer(const glm::dvec3 &position, const ObserverField &observer);

/// How much brighter than without the hole one eye can see the images of one order (0..3), by the star's
/// angle from the outward radial. Its use: of a group of stars, the ones that stay too faint to be seen or
/// out of the picture need not be drawn. Never short (tested against the exact images), and generous by
/// little more than the change of brightness across the group. Takes some ten microseconds to make, well
/// below one to ask.
class ImageBound {
public:
	/// gain(from, to): how much brighter, as a factor, a star's pixels may be where it is seen, in the
	/// radially moving frame, between these angles [rad] from the hole; 0: nothing there is in the picture.
	ImageBound(const LocalObserver &eye, int order, const LensingTables &tables,
			const std::function<double(double, double)> &gain);

	/// An upper bound, in magnitudes, of how much brighter than its rank any star of the group is; +infinity
	/// where a star may lie on the caustic, -infinity where none is in the picture. `slack` (rad) widens the
	/// group, for eyes that move a little.
	[[nodiscard]] double brightening(const StarGroup &group, double slack) const;

	/// What brightening() is at least for every group, in magnitudes; -infinity when that is not known.
	[[nodiscard]] double least_brightening() const;

private:
	static constexpr std::size_t kBins = 64;

	glm::dvec3 outward;
	/// Over bins of the star's angle: largest log2 of magnification times gain, largest ln of the frequency
	/// ratio g.
	std::array<double, kBins> log_magnification{};
	std::array<double, kBins> log_redshift{};
	bool never_redshifted = true;
};

} // namespace blackhole
