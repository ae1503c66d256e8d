// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/photometry/planck_table.h"
#include "core/photometry/radiometry.h"
#include "core/photometry/sky_brightness.h"

namespace blackhole {
namespace {

constexpr int kColumns = 256;
constexpr int kRows = 128;

/// Directions all over the sky.
std::vector<glm::dvec3> everywhere(int p_count) {
	std::vector<glm::dvec3> directions;
	for (int i = 0; i < p_count; ++i) {
		const double y = 1.0 - 2.0 * (i + 0.5) / p_count;
		const double turn = 2.399963229728653 * i;
		const double across = std::sqrt(1.0 - y * y);
		directions.emplace_back(across * std::cos(turn), y, across * std::sin(turn));
	}
	return directions;
}

TEST(SkyBrightness, AUniformPanoramaIsWhatWasPutIn) {
	std::vector<float> rgb;
	for (int i = 0; i < kColumns * kRows; ++i) {
		rgb.insert(rgb.end(), {0.5F, 0.25F, 0.125F});
	}
	const SkyBrightness sky = SkyBrightness::of_panorama(rgb.data(), kColumns, kRows);
	for (const glm::dvec3 &direction : everywhere(5000)) {
		const SkyBrightness::Light light = sky.at(direction);
		EXPECT_NEAR(light.luminance, 0.2126 * 0.5 + 0.7152 * 0.25 + 0.0722 * 0.125, 1e-6);
		EXPECT_NEAR(light.temperature, colour_temperature(0.5, 0.125), 0.1);
	}
}

TEST(SkyBrightness, APanoramaLiesAsTheShaderHasIt) {
	// One bright texel: u = frac(0.25 - RA/360 deg), v = (90 deg - Dec)/180 deg.
	const double right_ascension = 1.0;
	const double declination = 0.4;
	const double u = 0.25 - right_ascension / (2.0 * std::numbers::pi) + 1.0;
	const double v = 0.5 - declination / std::numbers::pi;
	const auto column = static_cast<std::size_t>((u - std::floor(u)) * kColumns);
	const auto row = static_cast<std::size_t>(v * kRows);
	std::vector<float> rgb(std::size_t{3} * kColumns * kRows, 0.0F);
	rgb[3 * (row * kColumns + column) + 1] = 1.0F;
	const SkyBrightness sky = SkyBrightness::of_panorama(rgb.data(), kColumns, kRows);
	EXPECT_GT(sky.at(world_direction(right_ascension, declination)).luminance, 0.0F);
	EXPECT_EQ(sky.at(-world_direction(right_ascension, declination)).luminance, 0.0F);
}

TEST(SkyBrightness, EvenlySpreadStarsAreASurface) {
	// As many stars of 10 mag as make a surface of so many magnitudes per square second of arc.
	constexpr int kStars = 400000;
	StarTable table;
	for (const glm::dvec3 &direction : everywhere(kStars)) {
		Star star;
		star.right_ascension = std::atan2(-direction.z, direction.x);
		star.declination = std::asin(direction.y);
		star.v_magnitude = 10.0F;
		star.temperature_k = 7000.0F;
		table.stars.push_back(star);
	}
	const double sky_arcseconds = 4.0 * std::numbers::pi / kSquareArcsecond;
	const double expected = surface_luminance(10.0 - 2.5 * std::log10(kStars / sky_arcseconds));
	const SkyBrightness sky = SkyBrightness::of_stars(table, 99.0);
	for (const glm::dvec3 &direction : everywhere(3000)) {
		EXPECT_NEAR(sky.at(direction).luminance / expected, 1.0, 0.06) << "some 260 stars a cell";
		EXPECT_NEAR(sky.at(direction).temperature, 7000.0, 1.0);
	}
	EXPECT_EQ(SkyBrightness::of_stars(table, 9.5).at({1.0, 0.0, 0.0}).luminance, 0.0F) << "the limit";
}

TEST(SkyBrightness, TheTemperatureIsTheLightsMean) {
	StarTable table;
	for (const float kelvin : {4000.0F, 10000.0F}) {
		Star star;
		star.right_ascension = 0.1;
		star.declination = 0.1;
		star.v_magnitude = 3.0F;
		star.temperature_k = kelvin;
		table.stars.push_back(star);
	}
	EXPECT_NEAR(SkyBrightness::of_stars(table, 99.0).at(world_direction(0.1, 0.1)).temperature, 7000.0, 0.1);
}

TEST(SkyBrightness, BlackIsBlack) {
	EXPECT_EQ(SkyBrightness().at({0.0, 0.0, -2.0}).luminance, 0.0F);
	EXPECT_EQ(SkyBrightness::of_stars(StarTable(), 99.0).at({0.0, 1.0, 0.0}).luminance, 0.0F);
	const std::vector<float> rgb(std::size_t{3} * kColumns * kRows, 0.0F);
	EXPECT_EQ(SkyBrightness::of_panorama(rgb.data(), kColumns, kRows).at({1.0, 1.0, 1.0}).luminance, 0.0F);
}

TEST(SkyBrightness, ColourTemperaturesAreThoseOfThePlanckTable) {
	const PlanckTable planck;
	for (const double kelvin : {2500.0, 4000.0, 5772.0, 9000.0, 20000.0}) {
		const double place = (PlanckTable::kCoolest + PlanckTable::kKnee) / (kelvin + PlanckTable::kKnee) *
				(kPlanckTableSize - 1);
		const auto texel = static_cast<std::size_t>(std::lround(place));
		const double red = planck.texels()[4 * texel];
		const double blue = planck.texels()[4 * texel + 2];
		EXPECT_NEAR(colour_temperature(red, blue) / kelvin, 1.0, 0.05) << kelvin;
	}
}

} // namespace
} // namespace blackhole
