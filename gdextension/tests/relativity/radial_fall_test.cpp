// SPDX-License-Identifier: MIT
#include "core/relativity/radial_fall.h"

#include "core/relativity/observer.h"
#include "relativity/brute_force_fall.h"
#include "relativity/reference_data.h"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace blackhole::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Energies on both sides of rain, and as near to it as doubles go.
const std::vector<double> kEnergies = {
		0.3, 0.9, 1.0 - 1e-6, std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0), 1.0 + 1e-9, 1.3, 50.0};

/// The proper time by quadrature of dr/sqrt(k + 1/r) with r = q^2.
double integrated_proper_time(double energy, double high, double low) {
	boost::math::quadrature::tanh_sinh<double> quadrature;
	const double excess = (energy - 1.0) * (energy + 1.0);
	return quadrature.integrate([&](double q) { return 2.0 * q * q / std::sqrt(1.0 + excess * q * q); },
			std::sqrt(low), std::sqrt(high), 1e-12);
}

/// The closed form T = eps tau + 2 [eps x - q + ln((1 + q)/(w + eps q))], from Schwarzschild's t with
/// the logarithms of the horizon taken together.
double closed_rain_time(double energy, double high, double low, double proper_time) {
	const double excess = (energy - 1.0) * (energy + 1.0);
	const auto bracket = [&](double r) {
		const double q = std::sqrt(r);
		const double w = std::sqrt(1.0 + excess * r);
		const double rate = std::sqrt(std::abs(excess));
		const double arc = excess < 0.0 ? std::asin(rate * q) / rate
				: excess > 0.0          ? std::asinh(rate * q) / rate
										: q;
		return energy * arc - q + std::log((1.0 + q) / (w + energy * q));
	};
	return energy * proper_time + 2.0 * (bracket(high) - bracket(low));
}

RadialFall fall_with(double energy) {
	return *RadialFall::with_energy(energy).value;
}

TEST(RadialFall, OfRainHasTheClosedForm) {
	const RadialFall rain = fall_with(1.0);
	for (const double high : {30.0, 2.0, 0.9}) {
		for (const double low : {0.5, 0.05, 0.0}) {
			const double expected = 2.0 / 3.0 * (std::pow(high, 1.5) - std::pow(low, 1.5));
			EXPECT_LT(relative_error(*rain.proper_time(high, low).value, expected), 1e-14);
			EXPECT_LT(relative_error(*rain.rain_time(high, low).value, expected), 1e-12);
		}
	}
}

TEST(RadialFall, AgreesWithTheEquationsOfMotion) {
	const std::vector<double> stops = {20.0, 1.0, 0.05};
	const RadialFall dropped = *RadialFall::from_rest(30.0).value;
	const RadialFall rain = fall_with(1.0);
	const auto slow = integrate_fall(30.0L, celerity_of_rest(30.0L), stops);
	const auto fast = integrate_fall(30.0L, 0.0L, stops);
	for (std::size_t i = 0; i < stops.size(); ++i) {
		EXPECT_LT(relative_error(*dropped.proper_time(30.0, stops[i]).value, slow[i].proper_time), 1e-12);
		EXPECT_LT(relative_error(*dropped.rain_time(30.0, stops[i]).value, slow[i].rain_time), 1e-12);
		EXPECT_LT(relative_error(*rain.proper_time(30.0, stops[i]).value, fast[i].proper_time), 1e-12);
		EXPECT_LT(relative_error(*rain.rain_time(30.0, stops[i]).value, fast[i].rain_time), 1e-12);
	}
}

TEST(RadialFall, WithEveryEnergyAgreesWithTheEquationsOfMotion) {
	for (const double energy : kEnergies) {
		const RadialFall fall = fall_with(energy);
		const double high = std::min(12.0, 0.8 * fall.highest_radius());
		const auto celerity = fall.radial_celerity(high);
		const auto times = integrate_fall(high, *celerity.value, {0.5 * high, 0.05});
		EXPECT_LT(relative_error(*fall.proper_time(high, 0.5 * high).value, times[0].proper_time), 1e-12)
				<< energy;
		EXPECT_LT(relative_error(*fall.rain_time(high, 0.05).value, times[1].rain_time), 1e-12) << energy;
	}
}

TEST(RadialFall, ProperTimeAgreesWithQuadrature) {
	for (const double energy : kEnergies) {
		const RadialFall fall = fall_with(energy);
		const double high = std::min(1e4, 0.9 * fall.highest_radius());
		for (const double low : {0.0, 1e-6, 0.5 * high, 0.9 * high}) {
			EXPECT_LT(relative_error(
							  *fall.proper_time(high, low).value, integrated_proper_time(energy, high, low)),
					2e-13)
					<< energy << " " << low;
		}
	}
}

TEST(RadialFall, RainTimeAgreesWithItsClosedForm) {
	for (const double energy : kEnergies) {
		const RadialFall fall = fall_with(energy);
		for (const double high : {0.9, 1.0, 30.0, 1e6}) {
			if (high < fall.highest_radius()) {
				const double proper_time = *fall.proper_time(high, 0.1).value;
				// The closed form loses digits near eps = 1 in its arc, and where its terms cancel.
				EXPECT_LT(relative_error(*fall.rain_time(high, 0.1).value,
								  closed_rain_time(energy, high, 0.1, proper_time)),
						energy > 10.0 ? 1e-11 : 1e-12)
						<< energy << " " << high;
			}
		}
	}
}

TEST(RadialFall, WholeDropIsHalfACycloid) {
	for (const double radius : {1.5, 30.0, 1e9}) {
		const RadialFall fall = *RadialFall::from_rest(radius).value;
		EXPECT_EQ(fall.highest_radius(), radius);
		EXPECT_LT(relative_error(*fall.proper_time(radius, 0.0).value,
						  0.5 * std::numbers::pi * std::pow(radius, 1.5)),
				1e-14);
	}
}

TEST(RadialFall, ShortWaysKeepTheirDigits) {
	for (const double energy : kEnergies) {
		const RadialFall fall = fall_with(energy);
		const double high = 0.8 * std::min(20.0, fall.highest_radius());
		const double low = high * (1.0 - 0x1p-30);
		const double speed = std::sqrt((energy - 1.0) * (energy + 1.0) + 1.0 / (0.5 * (high + low)));
		EXPECT_LT(relative_error(*fall.proper_time(high, low).value, (high - low) / speed), 1e-14) << energy;
		EXPECT_EQ(*fall.proper_time(high, high).value, 0.0);
		EXPECT_EQ(*fall.rain_time(high, high).value, 0.0);
	}
}

TEST(RadialFall, MomentsLieOnTheFall) {
	for (const double energy : kEnergies) {
		const RadialFall fall = fall_with(energy);
		const double start = std::min(30.0, fall.highest_radius());
		const double end = *fall.proper_time(start, 0.0).value;
		for (const double part : {1e-6, 0.1, 0.7, 0.999, 1.0 - 1e-9}) {
			const auto moment = fall.moment_after(start, part * end);
			ASSERT_TRUE(moment) << moment.error;
			const double radius = moment.value->radius;
			// Near a start at rest the radius, a double, can no longer tell the time.
			const double speed = std::sqrt((energy - 1.0) * (energy + 1.0) + 1.0 / radius);
			EXPECT_NEAR(
					*fall.proper_time(start, radius).value, part * end, 1e-15 * (4.0 * end + start / speed))
					<< energy << " " << part;
			if (part > 0.01) {
				EXPECT_NEAR(moment.value->celerity, *fall.radial_celerity(radius).value, 1e-13);
				EXPECT_LT(
						relative_error(moment.value->rain_time, *fall.rain_time(start, radius).value), 1e-12);
			}
		}
		EXPECT_EQ(fall.moment_after(start, 0.0).value->rain_time, 0.0);
		EXPECT_FALSE(fall.moment_after(start, 1.001 * end));
	}
}

TEST(RadialFall, RainTimeStartsSmoothlyFromRest) {
	// At first with the static observer's gamma; dgamma/dtau = -w^2 r^(-3/2)/2 by the geodesic equation.
	const RadialFall fall = *RadialFall::from_rest(30.0).value;
	const double gamma = 1.0 / std::sqrt(1.0 - 1.0 / 30.0);
	const double slowing = 0.5 / 29.0 * std::pow(30.0, -1.5);
	for (const double elapsed : {1e-4, 1e-2, 1.0}) {
		EXPECT_NEAR(fall.moment_after(30.0, elapsed).value->rain_time,
				gamma * elapsed - 0.5 * slowing * elapsed * elapsed, 1e-5 * std::pow(elapsed, 3) + 1e-13);
	}
}

TEST(RadialFall, RisesAsLongAsItFallsByItsOwnClock) {
	const RadialFall fall = fall_with(0.9);
	EXPECT_EQ(*fall.proper_time(2.0, 4.0).value, *fall.proper_time(4.0, 2.0).value);
	// PG time runs with the outward mover's gamma = (eps + sqrt(u (eps^2 - 1 + u)))/(1 - u).
	const auto gamma = [](double r) {
		const double u = 1.0 / r;
		return (0.9 + std::sqrt(u * (0.81 - 1.0 + u))) / (1.0 - u);
	};
	boost::math::quadrature::tanh_sinh<double> quadrature;
	const double expected =
			quadrature.integrate([&](double r) { return gamma(r) / std::sqrt(-0.19 + 1.0 / r); }, 1.01, 5.0);
	EXPECT_LT(relative_error(*fall.rain_time(1.01, 5.0).value, expected), 1e-12);
	// dT/dr goes as 2/(r - 1) outside of the horizon: no end of PG time as the start nears it.
	const double near = 1.0 + 1e-6;
	const double nearer = 1.0 + 1e-12;
	EXPECT_NEAR(*fall.rain_time(nearer, 5.0).value - *fall.rain_time(near, 5.0).value,
			2.0 * std::log((near - 1.0) / (nearer - 1.0)), 1e-5);
}

TEST(RadialFall, HasTheCelerityOfItsKappa) {
	for (const double energy : kEnergies) {
		const RadialFall fall = fall_with(energy);
		for (const double r : {0.05, 0.9, 1.0, 1.05}) {
			const glm::dvec3 place = glm::normalize(glm::dvec3(1.0, 2.0, -2.0)) * r;
			const glm::dvec3 inward = *radial_celerity(place, infall_kappa(1.0 / r, energy)).value;
			EXPECT_LT(glm::length(*fall.celerity(place).value - inward), 1e-14 * (1.0 + glm::length(inward)))
					<< energy << " " << r;
		}
		const glm::dvec3 place(0.0, 1.05, 0.0);
		const glm::dvec3 outward = *radial_celerity(place, outgoing_kappa(1.0 / 1.05, energy)).value;
		EXPECT_LT(glm::length(*fall.celerity(place, RadialWay::kOutward).value - outward),
				1e-13 * glm::length(outward));
	}
	const glm::dvec3 top(0.0, 0.0, 7.0);
	EXPECT_LT(glm::length(*RadialFall::from_rest(7.0).value->celerity(top).value -
					  *observer_celerity(ObserverMotion::kStatic, top).value),
			1e-15);
}

TEST(RadialFall, RefusesByName) {
	const auto says = [](const std::string &error, const char *words) {
		EXPECT_NE(error.find(words), std::string::npos) << error;
	};
	for (const double energy : {0.0, -1.0, kNaN, kInfinity}) {
		says(RadialFall::with_energy(energy).error, "positive number");
	}
	says(RadialFall::from_rest(1.0).error, "horizon");
	says(RadialFall::from_rest(kNaN).error, "number");
	EXPECT_EQ(RadialFall::from_rest(kInfinity).value->energy(), 1.0);
	const RadialFall bound = fall_with(0.6); // turns at 1/0.64
	says(bound.proper_time(2.0, 1.0).error,
			"energy 0.6 is too small for r = 2 r_s: this motion turns back at 1.5625");
	says(bound.rain_time(1.2, 2.0).error, "too small");
	says(bound.moment_after(2.0, 1.0).error, "too small");
	says(bound.celerity(glm::dvec3(0.0, 2.0, 0.0)).error, "too small");
	says(bound.proper_time(1.0, 1.5).error, "outward");
	says(bound.rain_time(0.5, 1.5).error, "outward");
	says(bound.moment_after(1.0, 1.0, RadialWay::kOutward).error, "outward");
	says(bound.celerity(glm::dvec3(0.5, 0.0, 0.0), RadialWay::kOutward).error, "outward");
	says(bound.proper_time(kNaN, 1.0).error, "radius");
	says(bound.proper_time(1.0, -0.1).error, "radius");
	says(bound.celerity(glm::dvec3(0.0)).error, "centre");
	says(bound.moment_after(1.2, kNaN).error, "time");
	says(bound.moment_after(1.2, -1.0).error, "time");
}

} // namespace
} // namespace blackhole::test
