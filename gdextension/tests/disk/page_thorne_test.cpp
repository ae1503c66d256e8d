// SPDX-License-Identifier: MIT
#include "core/disk/page_thorne.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace blackhole::test {
namespace {

// The vectors of page_thorne.csv are compared by reference_columns_test.cpp.

TEST(PageThorne, IsDarkWithinTheLastStableOrbit) {
	EXPECT_EQ(page_thorne_flux(2.9), 0.0);
	EXPECT_EQ(page_thorne_flux(3.0), 0.0);
	EXPECT_EQ(page_thorne_temperature(1.0), 0.0);
	EXPECT_TRUE(std::isnan(page_thorne_flux(std::nan(""))));
}

TEST(PageThorne, RisesWithTheSquareOfTheDistanceFromIt) {
	EXPECT_NEAR(page_thorne_flux(3.0 + 2e-7) / page_thorne_flux(3.0 + 1e-7), 4.0, 1e-5);
}

TEST(PageThorne, IsHottestAtTheHottestRing) {
	EXPECT_EQ(page_thorne_temperature(kHottestRing), 1.0);
	EXPECT_LT(page_thorne_temperature(kHottestRing - 0.01), 1.0);
	EXPECT_LT(page_thorne_temperature(kHottestRing + 0.01), 1.0);
}

TEST(PageThorne, FallsWithTheCubeOfTheRadiusFarOut) {
	EXPECT_NEAR(page_thorne_flux(2e8) / page_thorne_flux(1e8), 0.125, 1e-4);
	EXPECT_NEAR(page_thorne_temperature(2e8) / page_thorne_temperature(1e8), std::pow(0.125, 0.25), 1e-4);
}

TEST(PageThorne, GoesOnSmoothlyWhereItsTwoFormsMeet) {
	const double x = std::sqrt(6.0) + 0.5;
	const double r = 0.5 * x * x;
	EXPECT_NEAR(
			page_thorne_flux(std::nextafter(r, 0.0)) / page_thorne_flux(std::nextafter(r, 9.0)), 1.0, 1e-13);
}

TEST(PageThorne, TheHottestRingHasTheTemperatureOfTheFallOntoIt) {
	// By hand from G = 6.6743e-11, M_sun = 1.98841e30 kg, sigma = 5.670374419e-8 (SI).
	EXPECT_NEAR(hottest_ring_temperature(10.0, 1e-8) / 2.81339e6, 1.0, 1e-5);
	EXPECT_NEAR(hottest_ring_temperature(1e8, 0.1) / 50029.9, 1.0, 1e-5);
	// T ~ (rate/M^2)^(1/4)
	const double one = hottest_ring_temperature(1.0, 1e-8);
	EXPECT_NEAR(hottest_ring_temperature(16.0, 1e-8) / one, 0.25, 1e-14);
	EXPECT_NEAR(hottest_ring_temperature(1.0, 16e-8) / one, 2.0, 1e-14);
}

TEST(PageThorne, TheDiskRadiatesWhatTheGasHasLostOnItsWay) {
	// Energy at infinity of the light of both faces: int 2 sigma T^4 E 2 pi r dr, E = (1 - u)/sqrt(1 - 3u/2)
	// that of a circular orbit, is (1 - sqrt(8/9)) of the rest energy of what falls. Over s = sqrt(3u):
	// r dr = 2 r^3 s ds/3.
	constexpr double kMass = 10.0; // solar masses
	constexpr double kRate = 1e-8; // solar masses a year
	constexpr int kSteps = 4000;
	double sum = 0.0;
	for (int i = 0; i < kSteps; ++i) {
		const double s = (i + 0.5) / kSteps;
		const double r = 3.0 / (s * s);
		const double energy = (1.0 - 1.0 / r) / std::sqrt(1.0 - 1.5 / r);
		sum += std::pow(page_thorne_temperature(r), 4.0) * energy * 2.0 / 3.0 * r * r * r * s / kSteps;
	}
	constexpr double kLight = 299792458.0;                                     // m/s
	constexpr double kSun = 1.98841e30;                                        // kg
	constexpr double kStefanBoltzmann = 5.670374419e-8;                        // W/(m^2 K^4)
	const double radius = 2.0 * 6.6743e-11 * kMass * kSun / (kLight * kLight); // m
	const double hottest = kStefanBoltzmann * std::pow(hottest_ring_temperature(kMass, kRate), 4.0);
	const double light = 4.0 * std::numbers::pi * radius * radius * hottest * sum;
	const double fall = kRate * kSun / (365.25 * 86400.0) * kLight * kLight;
	EXPECT_NEAR(light / fall, 1.0 - std::sqrt(8.0 / 9.0), 1e-6);
}

} // namespace
} // namespace blackhole::test
