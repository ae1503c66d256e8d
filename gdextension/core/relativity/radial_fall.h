// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"

#include <glm/vec3.hpp>

#include <string>

namespace blackhole {

/// Which way a radial motion goes now.
enum class RadialWay {
	kInward,
	kOutward,
};

/// What is true at one proper time of a radial world line.
struct RadialMoment {
	double radius = 0.0;
	RadialWay way = RadialWay::kInward;
	/// Painleve-Gullstrand time since the start, the common clock of all rain observers.
	double rain_time = 0.0;
	/// Celerity gamma beta relative to the rain frame, outward: negative for what falls faster than rain.
	double celerity = 0.0;
};

/// Free motion along a radius with a conserved energy per rest mass eps: 1 is rain (from rest at infinity),
/// less turns back at 1/(1 - eps^2), more comes from infinity with speed. Lengths in r_s, times in r_s/c.
/// Everything holds down to r = 0; outward motion exists outside of the horizon only. Times have a relative
/// error below 1e-12. Failures name the reason.
class RadialFall {
public:
	/// Fails unless energy > 0 (all that comes from outside has that) and finite.
	static Outcome<RadialFall> with_energy(double energy);

	/// Dropped from rest at radius > 1; infinity gives rain.
	static Outcome<RadialFall> from_rest(double radius);

	[[nodiscard]] double energy() const { return energy_; }

	/// Where the motion turns back; infinite for energies of 1 and more.
	[[nodiscard]] double highest_radius() const { return top_; }

	/// Proper time of the way between two radii without a turn: inward for to < from, else outward.
	[[nodiscard]] Outcome<double> proper_time(double from, double to) const;

	/// The same in Painleve-Gullstrand time, the common clock of all rain observers.
	[[nodiscard]] Outcome<double> rain_time(double from, double to) const;

	/// The moment at the proper time `elapsed` >= 0 after it was at `from`, moving `way`; what rises with
	/// eps < 1 comes back. Fails after the end at r = 0. Times round to 1e-15 of the time from r = 0 to
	/// `from`, and so does the radius by as much times the speed.
	[[nodiscard]] Outcome<RadialMoment> moment_after(
			double from, double elapsed, RadialWay way = RadialWay::kInward) const;

	/// Celerity gamma beta relative to the rain frame at position_rs, in world axes.
	[[nodiscard]] Outcome<glm::dvec3> celerity(
			glm::dvec3 position_rs, RadialWay way = RadialWay::kInward) const;

	/// Its outward component, negative for what falls faster than rain.
	[[nodiscard]] Outcome<double> radial_celerity(double radius, RadialWay way = RadialWay::kInward) const;

private:
	RadialFall(double energy, double excess, double top) : energy_(energy), excess_(excess), top_(top) {}

	/// q = sqrt(r) and w = sqrt(1 + k r) at a place; dr/dtau = +-w/q.
	struct Regular {
		double radius;
		double q;
		double w;
	};
	[[nodiscard]] Regular at(double radius) const;
	[[nodiscard]] Regular at_arc(double x) const;
	[[nodiscard]] double arc_between(const Regular &low, const Regular &high) const;
	[[nodiscard]] double arc_from_centre(double radius) const;
	[[nodiscard]] double arc_after(double time) const;
	[[nodiscard]] double rain_time_of(const Regular &low, double whole, RadialWay way) const;
	[[nodiscard]] double celerity_of(const Regular &here, RadialWay way) const;
	[[nodiscard]] std::string why_not(double radius, RadialWay way) const;

	double energy_;
	/// k = eps^2 - 1, kept apart because it loses its digits near eps = 1.
	double excess_;
	double top_;
};

} // namespace blackhole
