// SPDX-License-Identifier: MIT
// The committed catalogue against facts published about it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/catalogue/star_file.h"
#include "core/photometry/colour_index.h"
#include "tests/catalogue/read_bytes.h"

namespace blackhole {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

class HipparcosCatalogue : public testing::Test {
protected:
	static void SetUpTestSuite() {
		s_bytes = read_bytes(BLACKHOLE_PROJECT_ROOT "/addons/blackhole_sky/data/hipparcos.stars");
		auto outcome = read_star_file(s_bytes, "hipparcos.stars");
		ASSERT_TRUE(outcome) << outcome.error;
		s_table = std::move(*outcome.value);
	}

	static const Star &star(std::uint32_t p_hip) {
		const auto found = std::find_if(s_table.stars.begin(), s_table.stars.end(),
				[p_hip](const Star &p_star) { return p_star.hip == p_hip; });
		EXPECT_NE(found, s_table.stars.end()) << "HIP " << p_hip;
		return found != s_table.stars.end() ? *found : s_table.stars.front();
	}

	static inline std::vector<std::uint8_t> s_bytes;
	static inline StarTable s_table;
};

TEST_F(HipparcosCatalogue, HasEveryStarBrightestFirst) {
	EXPECT_EQ(s_table.stars.size(), 118217U);
	EXPECT_LE(s_bytes.size(), 4'000'000U);
	EXPECT_TRUE(std::is_sorted(s_table.stars.begin(), s_table.stars.end(),
			[](const Star &p_a, const Star &p_b) { return p_a.v_magnitude < p_b.v_magnitude; }));
	std::vector<std::uint32_t> hips;
	for (const Star &each : s_table.stars) {
		hips.push_back(each.hip);
	}
	std::sort(hips.begin(), hips.end());
	EXPECT_EQ(std::adjacent_find(hips.begin(), hips.end()), hips.end()) << "a star comes twice";
}

TEST_F(HipparcosCatalogue, CountsToMagnitude) {
	EXPECT_EQ(s_table.count_to(6.0), 5044U);
	EXPECT_EQ(s_table.count_to(6.5), 8874U);
	EXPECT_EQ(s_table.count_to(8.0), 41411U);
	EXPECT_EQ(s_table.count_to(10.0), 108003U);
	const std::size_t count = s_table.count_to(6.3);
	EXPECT_FLOAT_EQ(s_table.stars[count - 1].v_magnitude, 6.3F) << "the limit itself is included";
	EXPECT_EQ(s_table.count_to(99.0), s_table.stars.size());
	EXPECT_EQ(s_table.count_to(-9.0), 0U);
}

struct KnownStar {
	const char *name;
	std::uint32_t hip;
	float v, b_minus_v, parallax_mas;
	double ra_deg, dec_deg; ///< SIMBAD, ICRS J2000 epoch 2000
};

// V, B-V and parallax of the sources; places at J2000 from SIMBAD.
constexpr KnownStar kKnownStars[] = {
		{"Sirius", 32349, -1.44F, 0.009F, 379.21F, 101.287155, -16.716116},
		{"Vega", 91262, 0.03F, -0.001F, 130.23F, 279.234735, 38.783689},
		{"Polaris", 11767, 1.97F, 0.636F, 7.54F, 37.954561, 89.264109},
		{"Betelgeuse", 27989, 0.45F, 1.500F, 6.55F, 88.792939, 7.407064},
		{"Rigel", 24436, 0.18F, -0.030F, 3.78F, 78.634467, -8.201638},
		{"Proxima", 70890, 11.01F, 1.807F, 771.64F, 217.428953, -62.679484},
};

TEST_F(HipparcosCatalogue, KnownStars) {
	for (const KnownStar &known : kKnownStars) {
		const Star &found = star(known.hip);
		EXPECT_EQ(s_table.name_of(found), known.name);
		EXPECT_FLOAT_EQ(found.v_magnitude, known.v) << known.name;
		EXPECT_FLOAT_EQ(found.b_minus_v, known.b_minus_v) << known.name;
		EXPECT_FLOAT_EQ(found.parallax_mas, known.parallax_mas) << known.name;
		const auto expected = world_direction(known.ra_deg * kDegree, known.dec_deg * kDegree);
		const auto got = world_direction(found);
		const double apart = std::hypot(got.x - expected.x, got.y - expected.y, got.z - expected.z);
		EXPECT_LT(apart / kDegree * 3600.0, 0.15) << known.name << ", seconds of arc";
	}
}

TEST_F(HipparcosCatalogue, UnknownsAreNotZero) {
	const auto count = [](auto p_test) {
		return std::count_if(s_table.stars.begin(), s_table.stars.end(), p_test);
	};
	EXPECT_EQ(count([](const Star &p_s) { return std::isnan(p_s.b_minus_v); }), 1280);
	EXPECT_EQ(count([](const Star &p_s) { return std::isnan(p_s.parallax_mas); }), 262);
	EXPECT_EQ(count([](const Star &p_s) { return p_s.parallax_mas <= 0.0F; }), 4013);
	EXPECT_EQ(
			count([](const Star &p_s) { return std::isnan(p_s.b_minus_v) && p_s.temperature_k != 5772.0F; }),
			0);
}

TEST_F(HipparcosCatalogue, TemperaturesKeepTheObservedColour) {
	const ColourTemperature temperature_of;
	EXPECT_NEAR(star(32349).temperature_k, 12'800.0F, 50.0F);
	for (const Star &each : s_table.stars) {
		if (!std::isnan(each.b_minus_v)) {
			ASSERT_NEAR(each.temperature_k, temperature_of(each.b_minus_v), 1.0 + 1e-4 * each.temperature_k)
					<< "HIP " << each.hip;
		}
	}
}

TEST_F(HipparcosCatalogue, LoadsFast) {
	double best_ms = 1e9;
	for (int run = 0; run < 5; ++run) {
		const auto start = std::chrono::steady_clock::now();
		const auto outcome = read_star_file(s_bytes, "hipparcos.stars");
		const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
		ASSERT_TRUE(outcome);
		best_ms = std::min(best_ms, spent.count());
	}
	RecordProperty("load_ms", std::to_string(best_ms));
	EXPECT_LT(best_ms, 40.0);
}

} // namespace
} // namespace blackhole
