// SPDX-License-Identifier: MIT
#include "core/disk/disk_point.h"

#include "core/disk/disk_glow.h"
#include "core/disk/page_thorne.h"
#include "core/relativity/observer.h"
#include "lut_cli/ray_source.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace blackhole::test {
namespace {

class DiskPoints : public testing::Test {
protected:
	double uniform(double low, double high) {
		return std::uniform_real_distribution<double>(low, high)(random);
	}
	glm::dvec3 direction() {
		const double height = uniform(-1.0, 1.0);
		const double turn = uniform(0.0, 6.28318);
		const double level = std::sqrt(1.0 - height * height);
		return {level * std::cos(turn), height, level * std::sin(turn)};
	}

	std::mt19937_64 random{3};
};

TEST_F(DiskPoints, AreThoseOfTheInclinationAndAzimuth) {
	const ExactRays exact;
	int seen = 0;
	for (int trial = 0; trial < 3000; ++trial) {
		const DiskView view{std::exp(uniform(-4.0, -0.1)), uniform(0.01, 3.13), uniform(0.05, 3.1),
				uniform(-3.1, 3.1), ObserverMotion::kStatic};
		const double across = std::sin(view.xi);
		const glm::dvec3 place(0.0, 0.0, 1.0 / view.u);
		const glm::dvec3 toward(
				across * std::cos(view.azimuth), -across * std::sin(view.azimuth), -std::cos(view.xi));
		const glm::dvec3 normal(2.0 * std::sin(view.inclination), 0.0, 2.0 * std::cos(view.inclination));
		const auto point =
				seen_disk_point(place, toward, {normal, false}, trial % 3, ObserverMotion::kStatic);
		ASSERT_TRUE(point) << point.error;
		const DiskMeeting expected = exact.disk(view, trial % 3);
		ASSERT_EQ(point.value->reached, !std::isnan(expected.r));
		if (!point.value->reached) {
			continue;
		}
		// Errors of direction grow with each half turn.
		EXPECT_NEAR(point.value->radius / expected.r, 1.0, 1e-7);
		EXPECT_NEAR(glm::dot(point.value->place, normal), 0.0, 1e-9);
		EXPECT_NEAR(glm::length(point.value->place), 1.0, 1e-12);
		if (expected.r > kInnermostStable) {
			EXPECT_NEAR(point.value->redshift / expected.redshift, 1.0, 1e-7);
			++seen;
		}
	}
	EXPECT_GT(seen, 250);
}

TEST_F(DiskPoints, AreTheSameForEveryObserverAtAPlace) {
	int seen = 0;
	for (int trial = 0; trial < 500; ++trial) {
		const glm::dvec3 place = direction() * uniform(4.0, 30.0);
		const DiskPlane plane{direction(), trial % 2 == 1};
		ObserverField moving(ObserverMotion::kVelocity);
		moving.celerity = direction() * uniform(0.1, 3.0);
		const glm::dvec3 in_rain = direction();
		const auto rain = seen_disk_point(place, in_rain, plane, 0, ObserverMotion::kRain);
		const auto boosted =
				seen_disk_point(place, boost_direction(in_rain, moving.celerity), plane, 0, moving);
		ASSERT_EQ(rain.value->reached, boosted.value->reached);
		if (rain.value->reached && rain.value->radius < 1e3) {
			EXPECT_NEAR(boosted.value->radius / rain.value->radius, 1.0, 1e-7);
			const double doppler = doppler_factor(in_rain, moving.celerity);
			EXPECT_NEAR(boosted.value->redshift / (rain.value->redshift * doppler), 1.0, 1e-7);
			++seen;
		}
	}
	EXPECT_GT(seen, 100);
}

TEST_F(DiskPoints, AreRefusedWhereThereIsNone) {
	const glm::dvec3 place(0.0, 0.0, 10.0);
	const glm::dvec3 toward(0.0, -0.1, -1.0);
	EXPECT_FALSE(seen_disk_point(place, toward, {}, -1, ObserverMotion::kStatic));
	EXPECT_FALSE(seen_disk_point(place, toward, {glm::dvec3(0.0), false}, 0, ObserverMotion::kStatic));
	EXPECT_FALSE(seen_disk_point(place * 0.05, toward, {}, 0, ObserverMotion::kStatic));
	EXPECT_FALSE(seen_disk_point(place, glm::dvec3(0.0), {}, 0, ObserverMotion::kRain));
}

TEST_F(DiskPoints, AreCrossingsOfAnyPlane) {
	int seen = 0;
	for (int trial = 0; trial < 2000; ++trial) {
		const glm::dvec3 place = direction() * uniform(1.1, 30.0);
		const glm::dvec3 normal = direction() * uniform(0.1, 10.0);
		const glm::dvec3 toward = direction();
		const int order = trial % 3;
		const auto point = seen_disk_point(place, toward, {normal, false}, order, ObserverMotion::kRain);
		const auto crossing = plane_crossing(place, toward, normal, order, ObserverMotion::kRain);
		ASSERT_TRUE(crossing) << crossing.error;
		ASSERT_EQ(crossing.value->reached, point.value->reached);
		if (crossing.value->reached) {
			EXPECT_EQ(crossing.value->radius, point.value->radius);
			EXPECT_NEAR(glm::distance(crossing.value->position / crossing.value->radius, point.value->place),
					0.0, 1e-14);
			++seen;
		}
	}
	EXPECT_GT(seen, 200);
}

TEST_F(DiskPoints, AreHalfATurnAwayForSomebodyOnThePlane) {
	int seen = 0;
	for (int trial = 0; trial < 500; ++trial) {
		const double r = uniform(1.2, 20.0);
		const double xi = uniform(0.1, 1.2);
		const double turn = uniform(0.1, 3.0) * (trial % 2 == 0 ? 1.0 : -1.0);
		const glm::dvec3 toward(std::sin(xi) * std::cos(turn), std::sin(xi) * std::sin(turn), -std::cos(xi));
		const auto on = [&](double height, int order) {
			const glm::dvec3 place(0.0, height, r);
			return *plane_crossing(place, toward, {0.0, 1.0, 0.0}, order, ObserverMotion::kRain).value;
		};
		for (int order = 0; order < 2; ++order) {
			const PlaneCrossing here = on(0.0, order);
			// Somebody a little off, on the side he looks to, does not meet the plane beside him either.
			const PlaneCrossing off = on(turn > 0.0 ? 1e-5 * r : -1e-5 * r, order);
			if (!here.reached || !off.reached || here.radius > 100.0) {
				continue;
			}
			EXPECT_NEAR(here.radius / off.radius, 1.0, 0.01);
			EXPECT_LT(std::abs(here.position.y), 1e-9 * here.radius);
			EXPECT_LT(here.position.z * (order == 0 ? 1.0 : -1.0), 0.0) << "the far side, then the near one";
			++seen;
		}
	}
	EXPECT_GT(seen, 60);
	const auto along =
			plane_crossing({0.0, 0.0, 8.0}, {0.5, 0.0, -1.0}, {0.0, 1.0, 0.0}, 0, ObserverMotion::kStatic);
	EXPECT_FALSE(along.value->reached) << "in the plane all the way";
}

TEST_F(DiskPoints, GlowAsTheDiskIsDrawn) {
	const LensingTables tables = bake_lensing_tables();
	const PlanckTable planck;
	GlowingDisk disk;
	disk.log2_brightness = -40.0;
	int bright = 0;
	for (int trial = 0; trial < 2000; ++trial) {
		disk.normal = direction();
		disk.retrograde = trial % 2 == 1;
		disk.opacity = trial % 3 == 0 ? 0.5 : 1.0;
		const glm::dvec3 place = direction() * uniform(5.0, 40.0);
		const glm::dvec3 toward = glm::normalize(-place + direction() * uniform(0.0, 15.0));
		double expected = 0.0;
		double through = 1.0;
		bool on_edge = false;
		for (int order = 0; order < disk.orders; ++order) {
			const auto point = seen_disk_point(
					place, toward, {disk.normal, disk.retrograde}, order, ObserverMotion::kStatic);
			const double r = point.value->radius;
			on_edge = on_edge || std::abs(r / 3.0 - 1.0) < 0.02 || std::abs(r / 15.0 - 1.0) < 0.02;
			if (point.value->reached && r >= kInnermostStable && r <= disk.outer_radius) {
				const double seen =
						page_thorne_temperature(r) * disk.peak_temperature * point.value->redshift;
				expected += through * disk.opacity *
						std::exp2(planck.log2_luminance(seen) + disk.log2_brightness);
				through *= 1.0 - disk.opacity;
			}
		}
		if (on_edge) {
			continue;
		}
		const DiskGlow glow = disk_glow(tables, planck, disk, place, toward, ObserverMotion::kStatic);
		ASSERT_NEAR(glow.luminance, expected, 0.02 * expected) << trial;
		ASSERT_NEAR(glow.through, through, 1e-9) << trial;
		bright += expected > 0.0 ? 1 : 0;
	}
	EXPECT_GT(bright, 500);
}

} // namespace
} // namespace blackhole::test
