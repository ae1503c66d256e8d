// SPDX-License-Identifier: MIT
// The map projections of the shaders, compiled as C++.
#include "core/projection/sky_map.h"

#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace blackhole {
namespace {

constexpr int kEquirectangular = 1;
constexpr int kMercator = 2;
constexpr int kMollweide = 3;
constexpr int kFisheye180 = 4;
constexpr int kFisheye360 = 6;
const glm::vec2 kPicture(2000.0F, 1000.0F);

glm::vec3 direction_of(double longitude_deg, double latitude_deg) {
	const double lon = longitude_deg * std::numbers::pi / 180.0;
	const double lat = latitude_deg * std::numbers::pi / 180.0;
	return glm::vec3(
			glm::dvec3(std::cos(lat) * std::sin(lon), std::sin(lat), -std::cos(lat) * std::cos(lon)));
}

TEST(SkyMap, ThereAndBackIsTheSameDirection) {
	std::mt19937 random(4);
	std::normal_distribution<float> normal;
	for (int map = kEquirectangular; map <= kFisheye360; ++map) {
		const SkyMap sky(map);
		int shown = 0;
		for (int i = 0; i < 3000; ++i) {
			const glm::vec3 direction =
					glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
			const auto pixel = sky.pixel(direction, kPicture);
			if (!pixel) {
				continue;
			}
			++shown;
			const auto back = sky.direction(*pixel, kPicture);
			if (back) { // the very edge may round to either side
				EXPECT_LT(glm::length(*back - direction), 2e-4F) << "map " << map;
			}
		}
		EXPECT_GT(shown, map == kFisheye180 ? 1300 : 1900) << "map " << map;
	}
}

TEST(SkyMap, PutsKnownPlacesWhereTheFormulasSay) {
	const auto place = [](int map, double longitude, double latitude) {
		return *SkyMap(map).pixel(direction_of(longitude, latitude), kPicture);
	};
	const auto near = [](const glm::vec2 &a, double x, double y) {
		EXPECT_NEAR(a.x, x, 0.01);
		EXPECT_NEAR(a.y, y, 0.01);
	};
	for (int map = kEquirectangular; map <= kFisheye360; ++map) {
		near(place(map, 0.0, 0.0), 1000.0, 500.0);
	}
	near(place(kEquirectangular, 90.0, 45.0), 1500.0, 250.0);
	near(place(kEquirectangular, -179.0, -89.0), 1000.0 - 179.0 / 0.18, 500.0 + 89.0 / 0.18);
	const double mercator = std::log(std::tan(std::numbers::pi / 4.0 + std::numbers::pi / 6.0)); // 60 degrees
	near(place(kMercator, 0.0, 60.0), 1000.0, 500.0 - 500.0 / std::numbers::pi * mercator);
	// Mollweide: half of the disk's area lies within 90 degrees; the poles are the ends of the short axis.
	near(place(kMollweide, 90.0, 0.0), 1500.0, 500.0);
	near(place(kMollweide, 0.0, 89.99), 1000.0, 0.0);
	near(place(kFisheye180, 0.0, 45.0), 1000.0, 250.0);
	near(place(kFisheye360, 90.0, 0.0), 1250.0, 500.0);
}

TEST(SkyMap, DoesNotShowWhatIsOutside) {
	EXPECT_FALSE(SkyMap(kFisheye180).pixel(direction_of(91.0, 0.0), kPicture));
	EXPECT_TRUE(SkyMap(kFisheye180).pixel(direction_of(89.0, 0.0), kPicture));
	EXPECT_FALSE(SkyMap(kMercator).pixel(direction_of(0.0, 85.2), kPicture));
	EXPECT_TRUE(SkyMap(kMercator).pixel(direction_of(0.0, 85.0), kPicture));
	EXPECT_FALSE(SkyMap(kMollweide).direction(glm::vec2(10.0F, 10.0F), kPicture));
	EXPECT_FALSE(SkyMap(kFisheye360).direction(glm::vec2(490.0F, 500.0F), kPicture));
}

} // namespace
} // namespace blackhole
