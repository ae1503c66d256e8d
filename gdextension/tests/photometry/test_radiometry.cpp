// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/photometry/constants.h"
#include "core/photometry/planck.h"
#include "core/photometry/radiometry.h"

namespace blackhole {
namespace {

constexpr double kSixtyDegrees = std::numbers::pi / 3.0;

/// Solid angle of the rectangle [x0, x1] x [y0, y1] in a plane at distance 1, exact.
double rectangle(double p_x0, double p_x1, double p_y0, double p_y1) {
	const auto corner = [](double p_x, double p_y) {
		return std::atan(p_x * p_y / std::sqrt(1.0 + p_x * p_x + p_y * p_y));
	};
	return corner(p_x1, p_y1) - corner(p_x0, p_y1) - corner(p_x1, p_y0) + corner(p_x0, p_y0);
}

TEST(Radiometry, ReferencePixel) {
	EXPECT_DOUBLE_EQ(pixel_solid_angle(kSixtyDegrees, 720), kReferenceSolidAngle);
	EXPECT_NEAR(star_luminance_sum(0.0, kReferenceSolidAngle), 30.0, 1e-12);
	EXPECT_NEAR(star_luminance_sum(5.0, kReferenceSolidAngle), 0.3, 1e-12);
}

TEST(Radiometry, PixelOffTheAxis) {
	const double side = 2.0 * std::tan(kSixtyDegrees / 2.0) / 720;
	for (const glm::dvec2 place : {glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.5), glm::dvec2(-0.3, -0.57)}) {
		const double exact =
				rectangle(place.x - side / 2, place.x + side / 2, place.y - side / 2, place.y + side / 2);
		EXPECT_NEAR(pixel_solid_angle(kSixtyDegrees, 720, place) / exact, 1.0, 1e-5);
	}
}

TEST(Radiometry, StarsAndSurfacesAgree) {
	// N stars of magnitude V spread over a solid angle W shine like a surface of V - 2.5 log10(N/W).
	const double solid_angle = 1e-3;
	const double stars = 5000.0;
	const double pixel = 1e-7;
	const double by_stars = stars * star_luminance_sum(10.0, pixel) * pixel / solid_angle;
	const double magnitude = 10.0 - 2.5 * std::log10(stars / (solid_angle / kSquareArcsecond));
	EXPECT_NEAR(by_stars / surface_luminance(magnitude), 1.0, 1e-12);
}

TEST(Radiometry, TheAddonShowsTheMilkyWayOnThisScale) {
	std::ifstream script(BLACKHOLE_PROJECT_ROOT "/addons/blackhole_sky/milky_way.gd");
	const std::string text{std::istreambuf_iterator<char>(script), {}};
	const std::string declaration = "const LUMINANCE: float = ";
	const std::size_t place = text.find(declaration);
	ASSERT_NE(place, std::string::npos);
	EXPECT_EQ(std::stod(text.substr(place + declaration.size())), kMilkyWayScale);
}

TEST(Radiometry, TheSunsSurfaceHasTheLightOfTheSunAsAStar) {
	const double pixel = 1e-9;
	const double sun = std::numbers::pi * kSolarAngularRadius * kSolarAngularRadius;
	const double surface = std::exp2(log2_luminance_unit()) * std::pow(10.0, planck_luminance_log10(5772.0));
	EXPECT_NEAR(surface * sun / pixel / star_luminance_sum(-26.74, pixel), 1.0, 1e-12);
}

TEST(Radiometry, TheUnitOfLuminanceIsThatOfTheMagnitudes) {
	// A star of magnitude 0 gives 2.54e-6 lux (Schlyter, Radiometry and photometry in astronomy); 1 cd/m2
	// gives 1 lux a steradian. The Sun is no black body.
	EXPECT_NEAR(std::exp2(log2_luminance_unit()) * 2.54e-6 / (kStarGain * kReferenceSolidAngle), 1.0, 0.03);
}

TEST(Radiometry, AngularRadii) {
	const PlanckTable planck;
	EXPECT_NEAR(star_angular_radius(kSolarMagnitude, kSolarTemperature, planck), kSolarAngularRadius, 1e-12);
	// Measured limb-darkened angular diameters in milliarcseconds; a star is no black body, hence 20 %.
	const double mas = std::numbers::pi / 180.0 / 3.6e6;
	EXPECT_NEAR(2.0 * star_angular_radius(-1.44, 9940.0, planck) / mas, 6.04, 1.2) << "Sirius";
	EXPECT_NEAR(2.0 * star_angular_radius(0.03, 9600.0, planck) / mas, 3.33, 0.67) << "Vega";
	EXPECT_NEAR(2.0 * star_angular_radius(-0.01, 5790.0, planck) / mas, 8.5, 1.7) << "Alpha Centauri A";
}

} // namespace
} // namespace blackhole
