// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>
#include <zlib.h>

#include "core/catalogue/star_file.h"

namespace blackhole {
namespace {

StarTable three_stars() {
	StarTable table;
	table.names = {"", "Second", "Fïrst"};
	table.stars = {
			{1.25, -0.5, 3.5F, 0.65F, 5700.0F, 12.5F, 7, 1},
			{6.28, std::numbers::pi / 2.0, -1.0F, kUnknown, 5772.0F, kUnknown, 0, 2},
			{0.0, -std::numbers::pi / 2.0, 9.0F, -0.2F, 24000.0F, -3.0F, 4294967295U, 0},
	};
	return table;
}

/// Puts the right checksum on altered bytes, so that the checks behind it are reached.
void seal(std::vector<std::uint8_t> &r_bytes) {
	const auto head = crc32(0, r_bytes.data(), 32);
	const auto crc = static_cast<std::uint32_t>(
			crc32(head, r_bytes.data() + 36, static_cast<unsigned>(r_bytes.size() - 36)));
	for (int i = 0; i < 4; ++i) {
		r_bytes[32U + static_cast<unsigned>(i)] = static_cast<std::uint8_t>(crc >> (8 * i));
	}
}

std::string error_of(const std::vector<std::uint8_t> &p_bytes) {
	const auto outcome = read_star_file(p_bytes, "sky.stars");
	EXPECT_FALSE(outcome);
	EXPECT_TRUE(outcome.error.starts_with("sky.stars: ")) << outcome.error;
	return outcome.error;
}

TEST(StarFile, ReturnsWhatWasWrittenBrightestFirst) {
	const auto outcome = read_star_file(write_star_file(three_stars()), "sky.stars");
	ASSERT_TRUE(outcome) << outcome.error;
	const StarTable &table = *outcome.value;
	ASSERT_EQ(table.stars.size(), 3U);
	EXPECT_EQ(table.name_of(table.stars[0]), "Fïrst");
	EXPECT_EQ(table.name_of(table.stars[1]), "Second");
	EXPECT_EQ(table.name_of(table.stars[2]), "");
	EXPECT_TRUE(std::isnan(table.stars[0].b_minus_v));
	EXPECT_TRUE(std::isnan(table.stars[0].parallax_mas));
	EXPECT_DOUBLE_EQ(table.stars[0].declination, std::numbers::pi / 2.0);
	EXPECT_NEAR(table.stars[1].right_ascension, 1.25, 7.4e-10);
	EXPECT_NEAR(table.stars[1].declination, -0.5, 7.4e-10);
	EXPECT_EQ(table.stars[1].v_magnitude, 3.5F);
	EXPECT_EQ(table.stars[1].b_minus_v, 0.65F);
	EXPECT_EQ(table.stars[1].temperature_k, 5700.0F);
	EXPECT_EQ(table.stars[1].parallax_mas, 12.5F);
	EXPECT_EQ(table.stars[1].hip, 7U);
	EXPECT_EQ(table.stars[2].hip, 4294967295U);
}

TEST(StarFile, AFullTurnIsWrittenAsZero) {
	StarTable table = three_stars();
	table.stars[0].right_ascension = std::nextafter(2.0 * std::numbers::pi, 0.0);
	const auto outcome = read_star_file(write_star_file(table), "sky.stars");
	ASSERT_TRUE(outcome) << outcome.error;
	EXPECT_EQ(outcome.value->stars[1].right_ascension, 0.0);
}

TEST(StarFile, RefusesEveryTruncation) {
	const auto bytes = write_star_file(three_stars());
	for (std::size_t size = 0; size < bytes.size(); ++size) {
		const std::string error =
				error_of({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)});
		EXPECT_NE(error.find(size < 36 ? "is not a .stars catalogue" : "truncated"), std::string::npos)
				<< error;
	}
}

TEST(StarFile, RefusesEveryFlippedBit) {
	const auto bytes = write_star_file(three_stars());
	for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
		auto damaged = bytes;
		damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
		error_of(damaged);
	}
}

TEST(StarFile, RefusesAnAnnouncedSizeWithoutAllocatingIt) {
	auto bytes = write_star_file(three_stars());
	std::memset(bytes.data() + 12, 0xFF, 12);
	seal(bytes);
	EXPECT_NE(error_of(bytes).find("truncated"), std::string::npos);
}

TEST(StarFile, RefusesAnotherVersion) {
	auto bytes = write_star_file(three_stars());
	bytes[8] = 2;
	seal(bytes);
	EXPECT_NE(error_of(bytes).find("version 2"), std::string::npos);
}

TEST(StarFile, RefusesAnEmptyTable) {
	EXPECT_NE(error_of(write_star_file(StarTable())).find("holds no star"), std::string::npos);
}

TEST(StarFile, RefusesValuesOutOfRange) {
	StarTable table = three_stars();
	table.stars[1].v_magnitude = kUnknown;
	EXPECT_NE(error_of(write_star_file(table)).find("out of range"), std::string::npos);
	table = three_stars();
	table.stars[1].temperature_k = -1.0F;
	EXPECT_NE(error_of(write_star_file(table)).find("out of range"), std::string::npos);
	table = three_stars();
	table.stars[1].declination = 1.6;
	EXPECT_NE(error_of(write_star_file(table)).find("out of range"), std::string::npos);
}

TEST(StarFile, RefusesANameOfAStarThatIsNotThere) {
	auto bytes = write_star_file(three_stars());
	bytes[36 + 3 * 28] = 3;
	seal(bytes);
	EXPECT_NE(error_of(bytes).find("out of range"), std::string::npos);
}

TEST(WorldDirection, AxesOfTheSky) {
	const double quarter = std::numbers::pi / 2.0;
	const auto expect_near = [](glm::dvec3 p_got, glm::dvec3 p_expected) {
		EXPECT_NEAR(p_got.x, p_expected.x, 1e-15);
		EXPECT_NEAR(p_got.y, p_expected.y, 1e-15);
		EXPECT_NEAR(p_got.z, p_expected.z, 1e-15);
	};
	expect_near(world_direction(0.0, 0.0), {1.0, 0.0, 0.0});
	expect_near(world_direction(quarter, 0.0), {0.0, 0.0, -1.0});
	expect_near(world_direction(1.0, quarter), {0.0, 1.0, 0.0});
}

} // namespace
} // namespace blackhole
