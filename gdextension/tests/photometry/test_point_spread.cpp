// SPDX-License-Identifier: MIT
// The patterns in which light spreads, against what is known of them.
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "core/photometry/cie1931.h"
#include "core/photometry/pixel_blur.h"
#include "core/photometry/point_spread.h"

namespace {

using namespace blackhole;
using std::numbers::pi;

/// Integral of a profile over the disk of radius p_r.
template <class Function>
double light_within(Function p_profile, double p_r) {
	double sum = 0.0;
	double from = 0.0;
	while (from < p_r) {
		const double to = std::min(p_r, from + std::max(0.5, 0.5 * from));
		sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
				[&](double x) { return 2.0 * pi * x * p_profile(x); }, from, to, 8, 1e-10);
		from = to;
	}
	return sum;
}

TEST(AiryPattern, LightWithinARadiusIsRayleighsFormula) {
	for (const double x : {0.1, 1.0, 2.5, 3.8317, 7.0156, 20.0, 60.0}) {
		const double j0 = std::cyl_bessel_j(0.0, x);
		const double j1 = std::cyl_bessel_j(1.0, x);
		EXPECT_NEAR(airy_encircled(x), 1.0 - j0 * j0 - j1 * j1, 1e-12) << x;
		EXPECT_NEAR(light_within(airy_profile, x), airy_encircled(x), 1e-8) << x;
	}
}

TEST(AiryPattern, KnownPointsOfTheProfile) {
	const double peak = airy_profile(0.0);
	EXPECT_NEAR(peak, 1.0 / (4.0 * pi), 1e-12);
	EXPECT_NEAR(airy_profile(1.6163399) / peak, 0.5, 1e-6);       // half maximum
	EXPECT_NEAR(airy_profile(5.1356223) / peak, 0.0174978, 1e-6); // first bright ring
	// The first dark ring is at 1.2197 lambda/D, and the disk inside of it holds 83.8 % of the light.
	const glm::dvec3 unit = airy_angles(0.1);
	for (int c = 0; c < 3; ++c) {
		const double dark = 1.21967 * kChannelWavelengths[c] / 0.1 / unit[c];
		EXPECT_LT(airy_profile(dark) / peak, 1e-9);
		EXPECT_NEAR(airy_encircled(dark), 0.8378, 1e-4);
	}
}

/// Distance, to the right positive, of a spectral colour from the line from white D65 through a primary;
/// infinite behind the white.
double beside(std::size_t p_sample, glm::dvec2 p_primary) {
	const glm::dvec2 white(0.3127, 0.3290);
	const ColourMatch &match = kCie1931[p_sample];
	const double sum = match.x + match.y + match.z;
	const glm::dvec2 colour = glm::dvec2(match.x, match.y) / sum - white;
	const glm::dvec2 along = p_primary - white;
	const bool ahead = colour.x * along.x + colour.y * along.y > 0.0;
	return ahead ? colour.x * along.y - colour.y * along.x : INFINITY;
}

TEST(AiryPattern, ChannelsHaveTheDominantWavelengthsOfThePrimaries) {
	const glm::dvec2 primaries[3] = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};
	for (int c = 0; c < 3; ++c) {
		double found = 0.0;
		for (std::size_t i = 40; i + 1 < 340; ++i) { // 400 to 700 nm
			const double here = beside(i, primaries[c]);
			const double next = beside(i + 1, primaries[c]);
			if (std::isfinite(here) && std::isfinite(next) && here * next <= 0.0) {
				found = kCieFirstNm + kCieStepNm * (static_cast<double>(i) + here / (here - next));
			}
		}
		EXPECT_NEAR(1e9 * kChannelWavelengths[c], found, 0.3) << c;
	}
}

TEST(EyePattern, PublishedFunctionHoldsAllTheLight) {
	const double degree = pi / 180.0;
	double sum = 0.0;
	for (double from = 0.0; from < 90.0;) {
		const double to = std::min(90.0, from + std::max(0.01, 0.5 * from));
		sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
				[&](double theta) {
					return eye_published(theta) * 2.0 * pi * std::sin(theta * degree) * degree;
				},
				from, to, 8, 1e-10);
		from = to;
	}
	EXPECT_NEAR(sum, 1.0, 0.03);
}

TEST(EyePattern, CoreAndWingsAreThePublishedFunction) {
	for (const double theta : {0.0, 0.005, 0.02, 0.05, 0.2, 1.0, 5.0, 20.0}) {
		const double x = theta / 0.02;
		const double core = std::exp(-x * x / (2.0 * kEyeCoreVariance)) / (2.0 * pi * kEyeCoreVariance);
		const double light = (1.0 - kEyeGlare) * core + kEyeGlare * eye_wings_profile(x);
		EXPECT_NEAR(light / (kEyeAngle * kEyeAngle) / eye_published(theta), 1.0, 0.03) << theta;
	}
}

TEST(EyePattern, WingsHoldTheirLight) {
	for (const double x : {0.3, 3.0, 50.0, 500.0}) {
		EXPECT_NEAR(light_within(eye_wings_profile, x), eye_wings_encircled(x), 1e-8) << x;
	}
	EXPECT_NEAR(eye_wings_encircled(4500.0), 1.0, 1e-3);
}

TEST(PixelBlur, GaussiansAddTheirVariances) {
	for (const double own : {0.02, 0.3, 1.0, 4.0}) {
		const auto encircled = [own](double r) { return -std::expm1(-r * r / (2.0 * own * own)); };
		const double variance = own * own + 0.49;
		for (const double r : {0.0, 0.2, 1.0, 2.5}) {
			const double exact = std::exp(-r * r / (2.0 * variance)) / (2.0 * pi * variance);
			EXPECT_NEAR(pixel_blurred(encircled, 0.7, r) / exact, 1.0, 2e-3) << own << " at " << r;
		}
	}
}

TEST(PixelBlur, WingsStayAsTheyAre) {
	// Far from a narrow pattern the blur adds the Laplacian times half the variance, 4.5 sigma^2/r^2.
	const auto encircled = [](double r) { return eye_wings_encircled(r / 0.1); };
	for (const double r : {15.0, 40.0, 120.0}) {
		const double bare = eye_wings_profile(r / 0.1) / 0.01;
		EXPECT_NEAR(pixel_blurred(encircled, 1.0, r) / bare, 1.0, 5.0 / (r * r) + 1e-4) << r;
	}
}

} // namespace
