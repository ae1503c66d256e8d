// SPDX-License-Identifier: MIT
#include "core/disk/page_thorne.h"

#include <cmath>

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

} // namespace
} // namespace blackhole::test
