// SPDX-License-Identifier: MIT
#pragma once

#include "core/culling/star_groups.h"
#include "core/relativity/observer.h"
#include "core/tables/lensing_tables.h"

#include <array>
#include <cstddef>
#include <functional>

#include <glm/vec3.hpp>

namespace blackhole {

/// What the bounds need of one eye; worked out once per eye and frame.
struct EyeBound {
	glm::dvec3 outward{0.0}; ///< unit vector from the hole to the eye, in the axes of the star groups
	double u = 0.0;          ///< r_s/r
	double kappa = 0.0;      ///< of the observer's motion
	bool is_static = false;
};

/// position: of the eye from the hole in r_s, in the axes of the star groups, not zero. A static observer at
/// or inside the horizon counts as rain, as in the shader.
EyeBound eye_bound(const glm::dvec3 &position, ObserverMotion motion);

/// How much brighter than without the hole one eye can see the images of one order (0..3), by the star's
/// angle from the outward radial. Its use: of a group of stars, the ones that stay too faint to be seen need
/// not be drawn. Never short (tested against the exact images), and generous by little more than the change
/// of brightness across the group. Takes some ten microseconds to make, well below one to ask.
class ImageBound {
public:
	/// gain(xi): how much brighter, as a factor, a star's pixels may be where it is seen within the angle xi
	/// [rad] of the hole; grows with xi.
	ImageBound(const EyeBound &eye, int order, const LensingTables &tables,
			const std::function<double(double)> &gain);

	/// An upper bound, in magnitudes, of how much brighter than its rank any star of the group is; +infinity
	/// where a star may lie on the caustic. `slack` (rad) widens the group, for eyes that move a little.
	[[nodiscard]] double brightening(const StarGroup &group, double slack) const;

	/// What brightening() is at least for every group, in magnitudes; -infinity when that is not known.
	[[nodiscard]] double least_brightening() const;

private:
	static constexpr std::size_t kBins = 64;

	glm::dvec3 outward;
	/// Over bins of the star's angle: largest log2 of magnification times gain.
	std::array<double, kBins> log_magnification{};
	/// At the bins' ends: ln of the frequency ratio g.
	std::array<double, kBins + 1> log_redshift{};
};

} // namespace blackhole
