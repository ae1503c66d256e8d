// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace blackhole {

inline constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Temperature of a star whose catalogue gives neither temperature nor colour: the Sun's, so that it looks
/// white.
inline constexpr float kTemperatureWithoutColour = 5772.0F;

/// Least and greatest value of a quantity.
struct Range {
	double least;
	double most;

	constexpr bool holds(double p_value) const { return p_value >= least && p_value <= most; }
};

/// What a catalogue may say of a star; anything else is a mistake, such as another unit.
inline constexpr Range kMagnitudes{-100.0, 100.0};
inline constexpr Range kColourIndices{-5.0, 20.0};
inline constexpr Range kTemperatures{100.0, 1e9};
inline constexpr Range kParallaxes{-1e6, 1e6};

/// How many stars a catalogue may have: with all that is made of it this many fill a large machine's memory.
inline constexpr std::size_t kMostStars = 50'000'000;

/// One star as its catalogue gives it. Angles are ICRS at epoch J2000.0.
struct Star {
	double right_ascension = 0.0;                    ///< radians, [0, 2 pi)
	double declination = 0.0;                        ///< radians, [-pi/2, pi/2]
	float v_magnitude = 0.0F;                        ///< Johnson V
	float b_minus_v = kUnknown;                      ///< Johnson B-V in magnitudes; NaN when unknown
	float temperature_k = kTemperatureWithoutColour; ///< of the black body it is drawn as, kelvin
	float parallax_mas =
			kUnknown;       ///< as measured: noise makes it zero or negative for far stars; NaN when unknown
	std::uint32_t hip = 0;  ///< Hipparcos number; 0 for none
	std::uint32_t name = 0; ///< place in StarTable::names
};

/// A catalogue, brightest star first.
struct StarTable {
	std::vector<Star> stars;
	std::vector<std::string> names = {""}; ///< proper names, UTF-8; the first is empty and stands for "none"

	const std::string &name_of(const Star &p_star) const { return names[p_star.name]; }

	/// How many stars are at least as bright as p_v_magnitude: they are the first ones of `stars`.
	std::size_t count_to(double p_v_magnitude) const;
	/// Puts the brightest star first; stars equally bright keep their order.
	void sort_by_magnitude();
};

/// Unit vector towards ICRS (p_right_ascension, p_declination), radians, in world axes: x to RA 0h Dec 0, y
/// to the north celestial pole, z to RA 18h Dec 0.
glm::dvec3 world_direction(double p_right_ascension, double p_declination);
glm::dvec3 world_direction(const Star &p_star);

} // namespace blackhole
