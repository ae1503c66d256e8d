// SPDX-License-Identifier: MIT
#include "core/relativity/radial_path.h"

#include "relativity/brute_force_fall.h"
#include "relativity/reference_data.h"

#include <cmath>
#include <limits>

namespace blackhole::test {
namespace {

RadialPath thrown_up(double radius, double energy) {
	return *RadialPath::start(*RadialFall::with_energy(energy).value, radius, RadialWay::kOutward).value;
}

TEST(RadialPath, OfTheFallRide) {
	// From 30 r_s through the horizon to 0.05 r_s, in rain and from rest.
	for (const bool from_rest : {false, true}) {
		const RadialFall fall =
				from_rest ? *RadialFall::from_rest(30.0).value : *RadialFall::with_energy(1.0).value;
		const RadialPath path = *RadialPath::start(fall, 30.0).value;
		const auto truth = integrate_fall(30.0L, from_rest ? celerity_of_rest(30.0L) : 0.0L, {1.0, 0.05});
		const double radii[] = {1.0, 0.05};
		for (int i = 0; i < 2; ++i) {
			EXPECT_NEAR(*path.proper_time_to(radii[i]).value, truth[i].proper_time, 1e-9);
			const RadialMoment moment = *path.at(truth[i].proper_time).value;
			EXPECT_NEAR(moment.radius, radii[i], 1e-9);
			EXPECT_NEAR(moment.rain_time, truth[i].rain_time, 1e-9);
			EXPECT_EQ(moment.way, RadialWay::kInward);
		}
		EXPECT_NEAR(path.at(0.0).value->radius, 30.0, 1e-13);
	}
}

TEST(RadialPath, ComesBackWhenThrownUpTooSlowly) {
	const double energy = 0.8; // turns at 1/0.36
	const RadialPath path = thrown_up(1.5, energy);
	const double top = path.fall().highest_radius();
	const double turn = *path.proper_time_to(top).value;
	EXPECT_NEAR(path.duration(), turn + *path.fall().proper_time(top, 0.0).value, 1e-14 * path.duration());
	for (const double before : {0.01, 0.3, 0.9}) {
		const RadialMoment up = *path.at(turn - before * turn).value;
		const RadialMoment down = *path.at(turn + before * turn).value;
		EXPECT_EQ(up.way, RadialWay::kOutward);
		EXPECT_EQ(down.way, RadialWay::kInward);
		EXPECT_NEAR(up.radius, down.radius, 1e-13);
		EXPECT_GT(up.celerity, down.celerity);
		EXPECT_NEAR(*path.proper_time_to(up.radius).value, turn - before * turn, 1e-12);
	}
	// The PG clock goes on without a jump at the turn, at the static observer's rate there.
	const double gap = 1e-3;
	const double passed = path.at(turn + gap).value->rain_time - path.at(turn - gap).value->rain_time;
	EXPECT_NEAR(passed, 2.0 * gap / std::sqrt(1.0 - 1.0 / top), 1e-8);
	EXPECT_NEAR(*path.proper_time_to(1.0).value, turn + *path.fall().proper_time(top, 1.0).value, 1e-13);
	EXPECT_FALSE(path.at(1.001 * path.duration()));
}

TEST(RadialPath, EscapesWithEnergyEnough) {
	const RadialPath path = thrown_up(2.0, 1.25);
	EXPECT_TRUE(std::isinf(path.duration()));
	const RadialMoment far = *path.at(1e6).value;
	EXPECT_EQ(far.way, RadialWay::kOutward);
	// In the end it moves at sqrt(eps^2 - 1) and clocks differ by the factor eps.
	EXPECT_LT(relative_error(far.radius, 0.75e6), 1e-4);
	EXPECT_LT(relative_error(far.rain_time, 1.25e6), 1e-2);
	EXPECT_LT(relative_error(*path.proper_time_to(far.radius).value, 1e6), 1e-13);
	EXPECT_FALSE(path.proper_time_to(1.9));
}

TEST(RadialPath, RefusesByName) {
	const RadialFall bound = *RadialFall::with_energy(0.8).value;
	EXPECT_NE(RadialPath::start(bound, 3.0).error.find("too small"), std::string::npos);
	EXPECT_NE(RadialPath::start(bound, 1.0, RadialWay::kOutward).error.find("horizon"), std::string::npos);
	EXPECT_NE(RadialPath::start(bound, 0.0).error.find("centre"), std::string::npos);
	EXPECT_FALSE(RadialPath::start(bound, std::numeric_limits<double>::quiet_NaN()));
	const RadialPath inward = *RadialPath::start(bound, 2.0).value;
	EXPECT_FALSE(inward.proper_time_to(2.5));
	EXPECT_FALSE(inward.at(-1.0));
	EXPECT_FALSE(inward.at(inward.duration()));
}

} // namespace
} // namespace blackhole::test
