// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/catalogue/star_csv.h"

namespace blackhole {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

StarTable table_of(std::string_view p_text) {
	auto outcome = read_star_csv(p_text, "sky.csv");
	EXPECT_TRUE(outcome) << outcome.error;
	return outcome ? std::move(*outcome.value) : StarTable();
}

TEST(StarCsv, RequiredColumnsAlone) {
	const StarTable table = table_of("ra_deg,dec_deg,vmag\n10.5,-20,3.25\n");
	ASSERT_EQ(table.stars.size(), 1U);
	const Star &star = table.stars[0];
	EXPECT_DOUBLE_EQ(star.right_ascension, 10.5 * kDegree);
	EXPECT_DOUBLE_EQ(star.declination, -20.0 * kDegree);
	EXPECT_EQ(star.v_magnitude, 3.25F);
	EXPECT_TRUE(std::isnan(star.b_minus_v));
	EXPECT_TRUE(std::isnan(star.parallax_mas));
	EXPECT_EQ(star.temperature_k, 5772.0F);
	EXPECT_EQ(star.hip, 0U);
	EXPECT_EQ(table.name_of(star), "");
}

TEST(StarCsv, AnyOrderFurtherColumnsQuotesMarksAndLineEnds) {
	const StarTable table =
			table_of("\xEF\xBB\xBF# a comment\r\n"
					 "\r\n"
					 "Name,spectrum,VMAG,hip,dec_deg,\"bv\",ra_deg,temperature_k,parallax_mas\r\n"
					 "\"A \"\"quoted\"\", name\",G2V,2.5,42,1e1,0.65,-90,,12.5\r\n"
					 "# another\r\n"
					 "  plain  , K0 ,+1.5, ,-45,1.0,360,6000,\r\n"
					 ",,9,,0,,0");
	ASSERT_EQ(table.stars.size(), 3U);
	EXPECT_EQ(table.name_of(table.stars[0]), "plain");
	EXPECT_EQ(table.stars[0].right_ascension, 0.0);
	EXPECT_EQ(table.stars[0].temperature_k, 6000.0F) << "a given temperature comes before the colour";
	EXPECT_TRUE(std::isnan(table.stars[0].parallax_mas));
	EXPECT_EQ(table.name_of(table.stars[1]), "A \"quoted\", name");
	EXPECT_DOUBLE_EQ(table.stars[1].right_ascension, 270.0 * kDegree);
	EXPECT_EQ(table.stars[1].hip, 42U);
	EXPECT_EQ(table.stars[1].parallax_mas, 12.5F);
	EXPECT_NEAR(table.stars[1].temperature_k, 5709.6F, 1.0F);
	EXPECT_EQ(table.stars[2].v_magnitude, 9.0F);
}

TEST(StarCsv, AQuotedFieldMayHoldALineEnd) {
	const StarTable table = table_of("ra_deg,dec_deg,vmag,name\n1,2,3,\"two\nlines\"\n4,5,6,x\n");
	ASSERT_EQ(table.stars.size(), 2U);
	EXPECT_EQ(table.name_of(table.stars[0]), "two\nlines");
}

struct Refusal {
	const char *text;
	const char *said; ///< must occur in the message
	int line;
};

class StarCsvRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(StarCsvRefusal, NamesFileLineAndRemedy) {
	const auto outcome = read_star_csv(GetParam().text, "sky.csv");
	ASSERT_FALSE(outcome);
	const std::string start = "sky.csv, line " + std::to_string(GetParam().line) + ": ";
	EXPECT_TRUE(outcome.error.starts_with(start)) << outcome.error;
	EXPECT_NE(outcome.error.find(GetParam().said), std::string::npos) << outcome.error;
}

INSTANTIATE_TEST_SUITE_P(All, StarCsvRefusal,
		testing::Values(Refusal{"", "file is empty", 1}, Refusal{"\n# only\n\n", "file is empty", 1},
				Refusal{"ra_deg,dec_deg,vmag\n", "add one row", 1},
				Refusal{"ra_deg,dec_deg\n1,2\n", "'vmag' is missing", 1},
				Refusal{"\n1,2,3\n", "'ra_deg' is missing", 2},
				Refusal{"ra_deg,dec_deg,vmag,RA_DEG\n1,2,3,4\n", "comes twice", 1},
				Refusal{"ra_deg,dec_deg,vmag\n1,2,3\n1,nan,3\n", "'nan' of column 'dec_deg'", 3},
				Refusal{"ra_deg,dec_deg,vmag\n1,2,inf\n", "'inf' of column 'vmag'", 2},
				Refusal{"ra_deg,dec_deg,vmag\n1,2,1e999\n", "'1e999' of column 'vmag'", 2},
				Refusal{"ra_deg,dec_deg,vmag\n361,2,3\n", "-360 to 360", 2},
				Refusal{"ra_deg,dec_deg,vmag\n1,-90.5,3\n", "-90 to 90", 2},
				Refusal{"ra_deg,dec_deg,vmag\n1,2,\n", "'' of column 'vmag'", 2},
				Refusal{"ra_deg,dec_deg,vmag\n1,2\n", "'' of column 'vmag'", 2},
				Refusal{"ra_deg,dec_deg,vmag\n1,2,3x\n", "'3x'", 2},
				Refusal{"ra_deg,dec_deg,vmag,temperature_k\n1,2,3,0\n", "100 to 1e9 kelvin", 2},
				Refusal{"ra_deg,dec_deg,vmag,bv\n1,2,3,NaN\n", "'NaN' of column 'bv'", 2},
				Refusal{"ra_deg,dec_deg,vmag,hip\n1,2,3,1.5\n", "whole number", 2},
				Refusal{"ra_deg,dec_deg,vmag,hip\n1,2,3,-1\n", "whole number", 2},
				Refusal{"ra_deg,dec_deg,vmag,name\n1,2,3,\"a\nb\"\n1,2,3,\"open\n", "never closed", 4},
				Refusal{"ra_deg,dec_deg,vmag,name\n1,2,3,\"a\"b\n", "closing quote", 2}));

} // namespace
} // namespace blackhole
