// SPDX-License-Identifier: MIT
#include "core/relativity/radial_fall.h"

#include "core/relativity/stumpff.h"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/roots.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

// (dr/dtau)^2 = k + 1/r. Levi-Civita's variables q = sqrt(r), w = sqrt(1 + k r) and the arc x with
// dtau = 2 r dx make it a harmonic oscillator: q' = w, w' = k q. From r = 0:
//   q = x c1(-k x^2),  w = c0(-k x^2),  tau = 4 x^3 c3(-4 k x^2).
// For k < 0 this is the cycloid with parameter 2 x sqrt(-k), for k > 0 its hyperbolic sibling.

namespace blackhole {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Radii and energies beyond this have no use, and their powers would overflow.
constexpr double kLargest = 1e30;
/// eps^2 - 1 + u that counts as rest: rounding of the energy.
constexpr double kRest = 4e-16;
/// The digits of tanh-sinh double with each level: what the last one changed by this is exact to rounding.
constexpr double kQuadratureTolerance = 1e-10;

std::string text(double value) {
	std::string digits = std::to_string(value);
	digits.erase(digits.find_last_not_of('0') + 1);
	if (digits.back() == '.') {
		digits.pop_back();
	}
	return digits;
}

/// asin or asinh of sqrt|k| sine, over sqrt|k|; `cosine` keeps the digits near the top of bound motion.
double arc(double excess, double sine, double cosine) {
	const double rate = std::sqrt(std::abs(excess));
	if (rate == 0.0) {
		return sine;
	}
	return (excess < 0.0 ? std::atan2(rate * sine, cosine) : std::asinh(rate * sine)) / rate;
}

double time_of_arc(double excess, double x) {
	return 4.0 * x * x * x * Stumpff::c3(-4.0 * excess * x * x);
}

} // namespace

Outcome<RadialFall> RadialFall::with_energy(double energy) {
	if (!(energy > 0.0 && energy <= kLargest)) {
		return Outcome<RadialFall>::failure(
				"the energy of a radial fall must be a positive number up to 1e30; 1 is rest at infinity");
	}
	const double excess = (energy - 1.0) * (energy + 1.0);
	return Outcome<RadialFall>::success(RadialFall(energy, excess, excess < 0.0 ? -1.0 / excess : kInfinity));
}

Outcome<RadialFall> RadialFall::from_rest(double radius) {
	if (radius == kInfinity) {
		return with_energy(1.0);
	}
	if (!(radius <= kLargest)) {
		return Outcome<RadialFall>::failure("the radius to fall from must be a number, at most 1e30 r_s");
	}
	if (radius <= 1.0) {
		return Outcome<RadialFall>::failure(
				"nothing can be at rest at or inside the horizon; drop it beyond r = 1 r_s");
	}
	return Outcome<RadialFall>::success(
			RadialFall(std::sqrt((radius - 1.0) / radius), -1.0 / radius, radius));
}

std::string RadialFall::why_not(double radius, RadialWay way) const {
	if (!(radius >= 0.0 && radius <= kLargest)) {
		return "a radius must be a number from 0 to 1e30 r_s";
	}
	if (excess_ + 1.0 / radius < -kRest && radius > top_) {
		return "the energy " + text(energy_) + " is too small for r = " + text(radius) +
				" r_s: this motion turns back at " + text(top_) + " r_s";
	}
	if (way == RadialWay::kOutward && radius <= 1.0) {
		return "nothing moves outward at or inside the horizon; start beyond r = 1 r_s";
	}
	return {};
}

RadialFall::Regular RadialFall::at(double radius) const {
	const double r = std::min(radius, top_);
	return {r, std::sqrt(r), std::sqrt(excess_ < 0.0 ? (top_ - r) / top_ : 1.0 + excess_ * r)};
}

RadialFall::Regular RadialFall::at_arc(double x) const {
	const double z = -excess_ * x * x;
	const double q = x * Stumpff::c1(z);
	return {std::min(q * q, top_), q, std::max(0.0, Stumpff::c0(z))};
}

double RadialFall::arc_between(const Regular &low, const Regular &high) const {
	if (!(high.radius > low.radius)) {
		return 0.0;
	}
	// sine and cosine of the difference of two arcs, without differences of like numbers
	const double sine = (high.radius - low.radius) / (high.q * low.w + low.q * high.w);
	return arc(excess_, sine, high.w * low.w - excess_ * high.q * low.q);
}

Outcome<double> RadialFall::proper_time(double from, double to) const {
	const RadialWay way = to > from ? RadialWay::kOutward : RadialWay::kInward;
	for (const double radius : {from, to}) {
		if (std::string reason = why_not(radius, way); !reason.empty()) {
			return Outcome<double>::failure(std::move(reason));
		}
	}
	// The universal Kepler equation from the lower end upwards: a sum of positive terms.
	const Regular low = at(std::min(from, to));
	const double s = 2.0 * arc_between(low, at(std::max(from, to)));
	const double z = -excess_ * s * s;
	return Outcome<double>::success(s *
			(low.radius * Stumpff::c1(z) + s * (low.q * low.w * Stumpff::c2(z) + 0.5 * s * Stumpff::c3(z))));
}

Outcome<double> RadialFall::rain_time(double from, double to) const {
	const RadialWay way = to > from ? RadialWay::kOutward : RadialWay::kInward;
	for (const double radius : {from, to}) {
		if (std::string reason = why_not(radius, way); !reason.empty()) {
			return Outcome<double>::failure(std::move(reason));
		}
	}
	const Regular low = at(std::min(from, to));
	return Outcome<double>::success(rain_time_of(low, arc_between(low, at(std::max(from, to))), way));
}

double RadialFall::rain_time_of(const Regular &low, double whole, RadialWay way) const {
	if (!(whole > 0.0)) {
		return 0.0;
	}
	// dT/dx = 2 r gamma with gamma = (eps^2 r + 1)/(eps r + w) inward, (eps r + w)/(r - 1) outward: analytic
	// through the horizon inward.
	const auto rate = [&](double x) {
		const double z = -excess_ * x * x;
		const double c1 = Stumpff::c1(z);
		const double step = low.w * x * c1 + excess_ * low.q * x * x * Stumpff::c2(z);
		const double q = low.q + step;
		const double w = low.w * Stumpff::c0(z) + excess_ * low.q * x * c1;
		const double r = q * q;
		const double moving = energy_ * r + w;
		if (way == RadialWay::kInward) {
			return 2.0 * r * (energy_ * energy_ * r + 1.0) / moving;
		}
		return 2.0 * r * moving / (low.radius - 1.0 + step * (q + low.q));
	};
	// Its points crowd at the lower end, where gamma varies most.
	static boost::math::quadrature::tanh_sinh<double> quadrature;
	return quadrature.integrate(rate, 0.0, whole, kQuadratureTolerance);
}

double RadialFall::arc_from_centre(double radius) const {
	return arc_between({0.0, 0.0, 1.0}, at(radius));
}

/// The arc from r = 0 on which this proper time passes.
double RadialFall::arc_after(double time) const {
	if (time <= 0.0) {
		return 0.0;
	}
	// Without k, tau = 2/3 x^3. Bound motion needs a longer arc than that, unbound a shorter one.
	const double free_arc = std::cbrt(1.5 * time);
	double guess = free_arc;
	double shortest = 0.0;
	double longest = free_arc;
	if (excess_ < 0.0) {
		longest = 0.5 * std::numbers::pi * std::sqrt(top_);
		if (free_arc >= longest) {
			return longest;
		}
		shortest = free_arc;
	} else if (excess_ > 0.0) {
		// 2 k^1.5 tau = sinh a - a with a = 2 x sqrt k, and sinh a - a > sinh(a)/2 from a = 2.2 on.
		const double rate = std::sqrt(excess_);
		const double bound = std::max(2.2, std::asinh(4.0 * rate * excess_ * time));
		guess = longest = std::min(free_arc, 0.5 * bound / rate);
	}
	const auto equation = [&](double x) {
		const double q = x * Stumpff::c1(-excess_ * x * x);
		return std::make_tuple(time_of_arc(excess_, x) - time, 2.0 * q * q);
	};
	std::uintmax_t iterations = 100;
	return boost::math::tools::newton_raphson_iterate(
			equation, guess, shortest, longest, std::numeric_limits<double>::digits - 2, iterations);
}

Outcome<RadialMoment> RadialFall::moment_after(double from, double elapsed, RadialWay way) const {
	if (std::string reason = why_not(from, way); !reason.empty()) {
		return Outcome<RadialMoment>::failure(std::move(reason));
	}
	if (!(elapsed >= 0.0 && elapsed < kInfinity)) {
		return Outcome<RadialMoment>::failure("the time of a fall must be a finite number, 0 or more");
	}
	double start_arc = arc_from_centre(from);
	double start = time_of_arc(excess_, start_arc);
	RadialMoment moment;
	if (way == RadialWay::kOutward) {
		const double rising = start + elapsed;
		const double top_arc = 0.5 * std::numbers::pi * std::sqrt(top_);
		const double top_time = 0.5 * std::numbers::pi * top_ * std::sqrt(top_);
		const bool turns = rising > top_time;
		const double x = turns ? top_arc : arc_after(rising);
		moment.rain_time = rain_time_of(at(from), x - start_arc, way);
		if (!turns) {
			Regular here = at_arc(x);
			here.radius = std::max(here.radius, from); // rounding must not lead back into the horizon
			moment.radius = here.radius;
			moment.way = way;
			moment.celerity = celerity_of(here, way);
			return Outcome<RadialMoment>::success(moment);
		}
		start_arc = top_arc;
		start = top_time;
		elapsed = rising - top_time;
	}
	const double x = arc_after(start - elapsed);
	if (!(x > 0.0)) {
		return Outcome<RadialMoment>::failure("the fall has ended at the centre by then");
	}
	const Regular here = at_arc(x);
	moment.radius = here.radius;
	moment.rain_time += rain_time_of(here, start_arc - x, RadialWay::kInward);
	moment.celerity = celerity_of(here, RadialWay::kInward);
	return Outcome<RadialMoment>::success(moment);
}

double RadialFall::celerity_of(const Regular &here, RadialWay way) const {
	// gamma beta = (dr/dtau + sqrt(u) eps)/(1 - u), which is -k/(sqrt(u) eps + sqrt(k + u)) inward
	const double sum = energy_ + here.w;
	return way == RadialWay::kInward ? -excess_ * here.q / sum : here.q * sum / (here.radius - 1.0);
}

Outcome<double> RadialFall::radial_celerity(double radius, RadialWay way) const {
	std::string reason = why_not(radius, way);
	if (reason.empty() && radius == 0.0) {
		reason = "no motion goes on at the centre";
	}
	return reason.empty() ? Outcome<double>::success(celerity_of(at(radius), way))
						  : Outcome<double>::failure(std::move(reason));
}

Outcome<glm::dvec3> RadialFall::celerity(glm::dvec3 position_rs, RadialWay way) const {
	const double r = glm::length(position_rs);
	const Outcome<double> outward = radial_celerity(r, way);
	return outward ? Outcome<glm::dvec3>::success(position_rs * (*outward.value / r))
				   : Outcome<glm::dvec3>::failure(outward.error);
}

} // namespace blackhole
