// SPDX-License-Identifier: MIT
#include "core/relativity/world_line.h"

#include "core/relativity/circular_orbit.h"
#include "core/relativity/observer.h"
#include "core/relativity/radial_path.h"
#include "relativity/reference_data.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace blackhole::test {
namespace {

const glm::dvec3 kOutward = glm::normalize(glm::dvec3(1.0, -2.0, 0.5));
const glm::dvec3 kNoThrust(0.0);

TEST(WorldLine, InFreeFallIsTheRadialFall) {
	for (const double energy : {0.0, 1.0, 1.4}) { // 0 stands for rest
		const RadialFall fall =
				energy == 0.0 ? *RadialFall::from_rest(30.0).value : *RadialFall::with_energy(energy).value;
		const RadialPath path = *RadialPath::start(fall, 30.0).value;
		WorldLine line = *WorldLine::start(30.0 * kOutward, *fall.celerity(30.0 * kOutward).value).value;
		const double end = *path.proper_time_to(0.05).value;
		for (int i = 1; i <= 10; ++i) {
			ASSERT_EQ(line.advance(0.1 * end, kNoThrust), WorldLineEnd::kOnTheWay);
			const RadialMoment moment = *path.at(0.1 * i * end).value;
			EXPECT_LT(glm::length(line.state().position - moment.radius * kOutward), 1e-8)
					<< energy << " " << i;
			EXPECT_LT(glm::length(line.state().celerity - moment.celerity * kOutward), 1e-8);
			EXPECT_NEAR(line.state().rain_time, moment.rain_time, 1e-8);
			EXPECT_NEAR(orbital_energy(line.state()), fall.energy(), 1e-9);
		}
	}
}

TEST(WorldLine, InFreeFallIsTheCircularOrbit) {
	const glm::dvec3 axis = glm::normalize(glm::cross(kOutward, glm::dvec3(0.3, 0.4, 1.0)));
	const CircularOrbit orbit = *CircularOrbit::through(10.0 * kOutward, axis).value;
	WorldLine line = *WorldLine::start(10.0 * kOutward, orbit.celerity_at(0.0)).value;
	for (int frame = 0; frame < 600; ++frame) { // a little over two turns
		ASSERT_EQ(line.advance(1.0, kNoThrust), WorldLineEnd::kOnTheWay);
	}
	EXPECT_LT(glm::length(line.state().position - orbit.position_at(600.0)), 1e-8);
	EXPECT_LT(glm::length(line.state().celerity - orbit.celerity_at(600.0)), 1e-8);
	EXPECT_LT(relative_error(line.state().rain_time, orbit.rain_time_at(600.0)), 1e-11);
	EXPECT_EQ(line.state().proper_time, 600.0);
}

TEST(WorldLine, KeepsEnergyAndAngularMomentum) {
	WorldLine line = *WorldLine::start(12.0 * kOutward, glm::dvec3(0.1, 0.25, -0.2)).value;
	const double energy = orbital_energy(line.state());
	const glm::dvec3 momentum = angular_momentum(line.state());
	for (int i = 0; i < 200; ++i) {
		line.advance(1.0, kNoThrust);
		ASSERT_NEAR(orbital_energy(line.state()), energy, 1e-10) << i;
		ASSERT_LT(glm::length(angular_momentum(line.state()) - momentum), 1e-10) << i;
	}
	// A plunge with angular momentum through the horizon keeps them as well.
	line = *WorldLine::start(glm::dvec3(3.0, 0.0, 0.0), glm::dvec3(-0.2, 0.5, 0.0)).value;
	const double plunging = orbital_energy(line.state());
	ASSERT_EQ(line.advance(100.0, kNoThrust), WorldLineEnd::kCentre);
	EXPECT_LT(relative_error(orbital_energy(line.state()), plunging), 1e-9);
	EXPECT_LT(glm::length(angular_momentum(line.state()) - glm::dvec3(0.0, 0.0, 1.5)), 1e-9);
}

TEST(WorldLine, WithItsWeightAsThrustStaysStatic) {
	for (const double r : {6.0, 10.0, 50.0}) {
		const glm::dvec3 place = r * kOutward;
		const double u = 1.0 / r;
		WorldLine line =
				*WorldLine::start(place, *observer_celerity(ObserverMotion::kStatic, place).value).value;
		const glm::dvec3 weight = kOutward * (u * u / (2.0 * std::sqrt(1.0 - u)));
		for (int i = 0; i < 100; ++i) {
			ASSERT_EQ(line.advance(1.0, weight), WorldLineEnd::kOnTheWay);
		}
		EXPECT_LT(glm::length(line.state().position - place), 1e-8) << r;
		EXPECT_NEAR(line.state().rain_time, 100.0 / std::sqrt(1.0 - u), 1e-8);
	}
}

TEST(WorldLine, OnACircleAtAnySpeedNeedsTheKnownThrust) {
	// A static observer's frame at r sees the circling one with speed V; the proper acceleration is then
	// gamma_V^2 (u^2/2 - V^2 u (1 - u))/sqrt(1 - u) outward. Here across the rain's boost, so in own axes.
	const double r = 5.0;
	const double u = 1.0 / r;
	const double speed = 0.7;
	const double gamma = 1.0 / std::sqrt(1.0 - speed * speed);
	const double needed = gamma * gamma * (0.5 * u * u - speed * speed * u * (1.0 - u)) / std::sqrt(1.0 - u);
	// Celerity from the static frame to rain: energy and momentum of that motion.
	const double energy = gamma * std::sqrt(1.0 - u);
	const double across = gamma * speed;
	const double out = std::sqrt(u) * energy / (1.0 - u);
	// The acceleration 4-vector is (sqrt(u)/sqrt(1 - u), 1/sqrt(1 - u)) needed in rain (e_T, e_r); the boost
	// back takes it to own axes.
	const double gamma_rain = std::sqrt(1.0 + across * across + out * out);
	const double a_time = needed * std::sqrt(u / (1.0 - u));
	const double a_out = needed / std::sqrt(1.0 - u);
	const double back = a_time / (1.0 + gamma_rain); // alpha = a - w a_T/(1 + gamma)
	const glm::dvec3 thrust(a_out - out * back, -across * back, 0.0);
	EXPECT_LT(relative_error(glm::length(thrust), std::abs(needed)), 1e-14);
	WorldLine line = *WorldLine::start(glm::dvec3(r, 0.0, 0.0), glm::dvec3(out, across, 0.0)).value;
	// The thrust turns with the place; a hundredth of a radian in short straight pieces.
	const int pieces = 2000;
	const double whole = 0.01 * r / across;
	for (int i = 0; i < pieces; ++i) {
		const double angle = 0.01 * (i + 0.5) / pieces;
		const glm::dvec3 turned(std::cos(angle) * thrust.x - std::sin(angle) * thrust.y,
				std::sin(angle) * thrust.x + std::cos(angle) * thrust.y, 0.0);
		ASSERT_EQ(line.advance(whole / pieces, turned), WorldLineEnd::kOnTheWay);
	}
	EXPECT_LT(glm::length(line.state().position - r * glm::dvec3(std::cos(0.01), std::sin(0.01), 0.0)), 1e-9);
	EXPECT_NEAR(orbital_energy(line.state()), energy, 1e-9);
}

TEST(WorldLine, FarAwayIsTheRocketOfFlatSpace) {
	// Constant proper acceleration from rest: celerity sinh(alpha tau), way (cosh(alpha tau) - 1)/alpha.
	const double r = 1e12;
	const double alpha = 0.3;
	const double tau = 10.0;
	WorldLine line = *WorldLine::start(glm::dvec3(r, 0.0, 0.0), glm::dvec3(0.0)).value;
	ASSERT_EQ(line.advance(tau, glm::dvec3(0.0, alpha, 0.0)), WorldLineEnd::kOnTheWay);
	EXPECT_LT(relative_error(line.state().celerity.y, std::sinh(alpha * tau)), 1e-11);
	EXPECT_LT(relative_error(line.state().position.y, (std::cosh(alpha * tau) - 1.0) / alpha), 1e-11);
	EXPECT_LT(relative_error(line.state().rain_time, std::sinh(alpha * tau) / alpha), 1e-11);
}

TEST(WorldLine, ComesBackInReverse) {
	const glm::dvec3 start = 8.0 * kOutward;
	const glm::dvec3 celerity(0.2, 0.3, -0.1);
	const glm::dvec3 thrust(0.02, -0.01, 0.03);
	WorldLine line = *WorldLine::start(start, celerity).value;
	ASSERT_EQ(line.advance(5.0, thrust), WorldLineEnd::kOnTheWay);
	EXPECT_GT(glm::length(line.state().position - start), 1.0);
	ASSERT_EQ(line.advance(-5.0, thrust), WorldLineEnd::kOnTheWay);
	EXPECT_LT(glm::length(line.state().position - start), 1e-10);
	EXPECT_LT(glm::length(line.state().celerity - celerity), 1e-10);
	EXPECT_NEAR(line.state().rain_time, 0.0, 1e-10);
	EXPECT_EQ(line.state().proper_time, 0.0);
}

TEST(WorldLine, StopsAtTheSmallestRadiusAndLeadsBackFromThere) {
	const RadialFall rain = *RadialFall::with_energy(1.0).value;
	WorldLine line = *WorldLine::start(kOutward, glm::dvec3(0.0)).value;
	ASSERT_EQ(line.advance(100.0, kNoThrust), WorldLineEnd::kCentre);
	EXPECT_NEAR(glm::length(line.state().position), kWorldLineEnd, 1e-14);
	const double passed = *rain.proper_time(1.0, kWorldLineEnd).value;
	EXPECT_NEAR(line.state().proper_time, passed, 1e-11);
	const WorldLineState end = line.state();
	EXPECT_EQ(line.advance(1.0, kNoThrust), WorldLineEnd::kCentre);
	EXPECT_EQ(line.state().proper_time, end.proper_time);
	// No thrust helps out of it.
	EXPECT_EQ(line.advance(1.0, 1e3 * kOutward), WorldLineEnd::kCentre);
	ASSERT_EQ(line.advance(-passed, kNoThrust), WorldLineEnd::kOnTheWay);
	EXPECT_LT(glm::length(line.state().position - kOutward), 1e-10);
}

TEST(WorldLine, NoThrustLeadsOutOfTheHorizon) {
	for (const double thrust : {0.1, 1.0, 30.0}) {
		WorldLine line = *WorldLine::start(0.99 * kOutward, glm::dvec3(0.0)).value;
		double radius = 0.99;
		WorldLineEnd end = WorldLineEnd::kOnTheWay;
		while (end == WorldLineEnd::kOnTheWay) {
			end = line.advance(0.01, thrust * kOutward);
			ASSERT_LT(glm::length(line.state().position), radius);
			radius = glm::length(line.state().position);
		}
		EXPECT_EQ(end, WorldLineEnd::kCentre) << thrust;
	}
}

TEST(WorldLine, EndsInReportsAndNotInNonsense) {
	const double nan = std::numeric_limits<double>::quiet_NaN();
	EXPECT_FALSE(WorldLine::start(0.009 * kOutward, glm::dvec3(0.0)));
	EXPECT_FALSE(WorldLine::start(glm::dvec3(nan, 1.0, 0.0), glm::dvec3(0.0)));
	EXPECT_FALSE(WorldLine::start(kOutward, glm::dvec3(nan, 0.0, 0.0)));
	EXPECT_FALSE(WorldLine::start(kOutward, glm::dvec3(1e7, 0.0, 0.0)));
	WorldLine line = *WorldLine::start(8.0 * kOutward, glm::dvec3(0.0)).value;
	EXPECT_EQ(line.advance(nan, kNoThrust), WorldLineEnd::kRefused);
	EXPECT_EQ(line.advance(1.0, glm::dvec3(nan, 0.0, 0.0)), WorldLineEnd::kRefused);
	EXPECT_EQ(line.state().proper_time, 0.0);
	EXPECT_EQ(line.advance(0.0, kNoThrust), WorldLineEnd::kOnTheWay);
	// Thrust without end comes too near to light.
	EXPECT_EQ(line.advance(1e3, glm::dvec3(0.0, 1.0, 0.0)), WorldLineEnd::kTooFast);
	EXPECT_TRUE(std::isfinite(glm::length(line.state().celerity)));
	EXPECT_LT(line.state().proper_time, 1e3);
}

} // namespace
} // namespace blackhole::test
