// SPDX-License-Identifier: MIT
#include "core/culling/buffer_plan.h"

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace blackhole {
namespace {

TEST(BufferPlan, HoldsWhatIsNeededAndNothingBefore) {
	BufferPlan plan({100, 200}, 1000);
	EXPECT_EQ(plan.total(), 0U);
	EXPECT_EQ(plan.need(1, 50), std::vector<std::size_t>{1});
	EXPECT_GE(plan.holds(1), 50U);
	EXPECT_EQ(plan.holds(0), 0U);
	EXPECT_EQ(plan.total(), plan.holds(1));
}

TEST(BufferPlan, IsNotMadeAnewForLess) {
	BufferPlan plan({1000}, 1000);
	plan.need(0, 500);
	const std::size_t held = plan.holds(0);
	EXPECT_TRUE(plan.need(0, 10).empty());
	EXPECT_TRUE(plan.need(0, 0).empty());
	EXPECT_TRUE(plan.need(0, held).empty());
	EXPECT_EQ(plan.holds(0), held);
}

TEST(BufferPlan, NeverHoldsMoreThanThereIs) {
	BufferPlan plan({100}, 1000);
	plan.need(0, 90);
	EXPECT_LE(plan.holds(0), 100U);
	plan.need(0, 5000);
	EXPECT_EQ(plan.holds(0), 100U);
	EXPECT_TRUE(plan.need(0, 100).empty());
}

TEST(BufferPlan, TakesBackFromOthersWhenAllTogetherHoldTooMuch) {
	BufferPlan plan({1000, 1000, 1000}, 1200);
	plan.need(0, 600);
	plan.need(0, 10);
	const std::vector<std::size_t> changed = plan.need(1, 900);
	EXPECT_TRUE(std::find(changed.begin(), changed.end(), std::size_t{0}) != changed.end());
	EXPECT_GE(plan.holds(0), 10U);
	EXPECT_LT(plan.holds(0), 100U);
	EXPECT_LE(plan.total(), 1200U);
}

TEST(BufferPlan, HoldsMoreThanWishedRatherThanTooLittle) {
	BufferPlan plan({1000, 1000}, 100);
	plan.need(0, 700);
	plan.need(1, 800);
	EXPECT_GE(plan.holds(0), 700U);
	EXPECT_GE(plan.holds(1), 800U);
}

TEST(BufferPlan, KnowsHowMuchIsNeeded) {
	BufferPlan plan({1000, 1000}, 1000);
	EXPECT_EQ(plan.pressure(), 0.0);
	plan.need(0, 300);
	plan.need(1, 500);
	EXPECT_NEAR(plan.pressure(), 0.8, 1e-3);
	plan.need(0, 0);
	EXPECT_NEAR(plan.pressure(), 0.5, 1e-3);
}

TEST(BufferPlan, TakesBackFromWhatNeedsLessWhileTooMuchIsHeld) {
	BufferPlan plan({1000, 1000}, 1000);
	plan.need(0, 700);
	plan.need(1, 700);
	ASSERT_GT(plan.total(), 1000U);
	EXPECT_EQ(plan.need(0, 0), std::vector<std::size_t>{0});
	EXPECT_LE(plan.total(), 1000U);
}

/// Needs that swell and shrink one after another, as those of the groups that an eye passes.
TEST(BufferPlan, WritesLittleOverTime) {
	constexpr std::size_t kBuffers = 150;
	constexpr std::size_t kLength = 800;
	constexpr std::size_t kMost = kBuffers * kLength / 4;
	BufferPlan plan(std::vector<std::size_t>(kBuffers, kLength), kMost);
	std::mt19937 random(3);
	std::vector<std::size_t> needs(kBuffers, 0);
	std::size_t grown = 0;
	std::size_t written = 0;
	for (int step = 0; step < 20000; ++step) {
		const std::size_t buffer = random() % kBuffers;
		// About one in ten is seen; so many rows fit with much to spare.
		const std::size_t rows = random() % 10 == 0 ? random() % kLength : random() % 40;
		grown += rows > needs[buffer] ? rows - needs[buffer] : 0;
		needs[buffer] = rows;
		for (const std::size_t changed : plan.need(buffer, rows)) {
			written += plan.holds(changed);
		}
		ASSERT_LE(plan.total(), kMost);
		for (std::size_t i = 0; i < kBuffers; ++i) {
			ASSERT_GE(plan.holds(i), needs[i]);
		}
	}
	EXPECT_LT(written, 3 * grown);
}

} // namespace
} // namespace blackhole
