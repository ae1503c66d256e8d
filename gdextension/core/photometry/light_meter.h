// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace blackhole {

/// How bright a picture is to the eye or to a camera's meter: luminances in a fixed set of directions about
/// the viewing axis, of which a few are renewed in each frame, and their centre-weighted mean.
class LightMeter {
public:
	static constexpr std::size_t kDirections = 144;
	/// What lies in the eye beside the image: light that the eye scatters over the retina, as a part of the
	/// mean. It keeps darkness within a picture (the hole's shadow) from counting as more than dim; without
	/// it the logarithm of the shadow would have no bound.
	static constexpr double kVeil = 0.25;
	/// How far above the mean the brightest part of a picture may lie. Beyond, that part decides: a small
	/// bright sky over a black hole that fills the picture would else be burnt out.
	static constexpr double kHeadroom = 64.0;

	/// Unit direction number `p_number` (0 to kDirections - 1), with the viewing axis along z; the picture's
	/// corners are p_half_angle [rad, to pi] from the axis. Equal solid angles, a sunflower's order.
	static glm::dvec3 direction(std::size_t p_number, double p_half_angle);

	/// The direction whose luminance is to be measured next. They take turns so that each few are spread over
	/// the picture.
	std::size_t next();
	void set_luminance(std::size_t p_number, double p_luminance) { m_luminance.at(p_number) = p_luminance; }

	/// The centre-weighted mean, at exposure 0: 2^<log2(L + veil)>, in such a unit that a uniform picture of
	/// luminance L gives L; or the brightest part's 64th where that is more. In proportion to the picture's
	/// luminance; 0 for a black one.
	double mean() const;

private:
	std::array<double, kDirections> m_luminance{};
	std::size_t m_next = 0;
};

} // namespace blackhole
