// SPDX-License-Identifier: MIT
// The shader's own formulas in single precision against the exact solution and against an integrator.
#include "core/tables/shader_disk.h"

#include "core/relativity/critical.h"
#include "core/relativity/view_angle.h"
#include "disk/integrated_sight.h"
#include "lut_cli/ray_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace blackhole::test {
namespace {

constexpr double kPi = std::numbers::pi;

const LensingTables &baked() {
	static const LensingTables tables = bake_lensing_tables();
	return tables;
}

class RandomViews {
public:
	explicit RandomViews(unsigned seed) : random(seed) {}

	DiskView next() {
		DiskView view;
		const bool rain = uniform(0.0, 1.0) < 0.5;
		view.motion = rain ? ObserverMotion::kRain : ObserverMotion::kStatic;
		view.u = std::exp(uniform(std::log(0.01), std::log(rain ? 4.0 : 0.98)));
		view.inclination = uniform(0.0, kPi);
		view.xi = uniform(0.02, kPi - 0.02);
		view.azimuth = uniform(-kPi, kPi);
		return view;
	}

private:
	double uniform(double low, double high) {
		return std::uniform_real_distribution<double>(low, high)(random);
	}

	std::mt19937_64 random;
};

/// The meeting found from a direction, as the shader starts.
class ShaderMeetings {
public:
	explicit ShaderMeetings(const DiskView &view) : u(view.u), place(0.0, 0.0, 1.0 / view.u) {
		const double across = std::sin(view.xi);
		direction = glm::dvec3(
				across * std::cos(view.azimuth), -across * std::sin(view.azimuth), -std::cos(view.xi));
		normal = glm::dvec3(std::sin(view.inclination), 0.0, std::cos(view.inclination));
		observer.motion = view.motion;
	}
	ShaderDisk::Crossing at(int order) const {
		return ShaderDisk(baked()).crossing(
				glm::vec3(place), glm::vec3(direction), glm::vec3(normal), order, observer);
	}
	/// r, 0 where there is none.
	double radius(const ShaderDisk::Crossing &found) const {
		const double at = found.inverse_radius;
		return found.reached && at > 0.0 && at < std::max(1.0, u) ? 1.0 / at : 0.0;
	}

private:
	double u;
	glm::dvec3 place;
	glm::dvec3 direction;
	glm::dvec3 normal;
	ObserverField observer;
};

/// Whether the disk reaches as far as this.
bool is_in_disk(double r) {
	return r >= 3.0 && r <= 30.0;
}

TEST(ShaderDisk, MissesNoCrossingAndInventsNone) {
	const ExactRays exact;
	RandomViews views(7);
	constexpr double kRelative[] = {5e-4, 5e-3, 3e-2};
	constexpr double kShift[] = {1e-3, 5e-3, 3e-2};
	int hits[3] = {};
	int below = 0;
	for (int trial = 0; trial < 100000; ++trial) {
		const DiskView view = views.next();
		const ShaderMeetings meetings(view);
		for (int order = 0; order < 3; ++order) {
			const DiskMeeting truth = exact.disk(view, order);
			const ShaderDisk::Crossing found = meetings.at(order);
			const double found_r = meetings.radius(found);
			if (is_in_disk(truth.r) != is_in_disk(found_r)) {
				// Only on the very edge.
				const double r = is_in_disk(truth.r) ? truth.r : found_r;
				const double off = std::min(std::abs(r / 3.0 - 1.0), std::abs(r / 30.0 - 1.0));
				ASSERT_LT(off, kRelative[order])
						<< "u " << view.u << " inclination " << view.inclination << " xi " << view.xi
						<< " azimuth " << view.azimuth << " order " << order;
				continue;
			}
			if (is_in_disk(truth.r)) {
				++hits[order];
				below += view.inclination > 0.5 * kPi ? 1 : 0;
				ASSERT_LT(std::abs(found_r / truth.r - 1.0), kRelative[order]) << "trial " << trial;
				ASSERT_LT(std::abs(found.redshift - truth.redshift), kShift[order]) << "trial " << trial;
			}
		}
	}
	EXPECT_GT(hits[0], 15000);
	EXPECT_GT(hits[1], 500);
	EXPECT_GT(hits[2], 10);
	EXPECT_GT(below, 7000);
}

TEST(ShaderDisk, KnowsHowLongLightWasOnItsWay) {
	const ExactRays exact;
	RandomViews views(11);
	int seen[3] = {};
	for (int trial = 0; trial < 4000; ++trial) {
		const DiskView view = views.next();
		const bool rests = view.motion == ObserverMotion::kStatic;
		const double slope = rests ? slope_from_static(view.u, view.xi) : slope_from_rain(view.u, view.xi);
		IntegratedSight sight(view.u, slope);
		const double y = rests ? static_sigma_offset(view.u, view.xi) : rain_sigma_offset(view.u, view.xi);
		if (std::abs(y) < 1e-4) {
			continue; // single precision does not tell the ray from the critical one
		}
		const ShaderMeetings meetings(view);
		const double first = first_meeting_angle(view.inclination, view.azimuth);
		for (int order = 0; order < 2; ++order) {
			const double r = sight.radius_at(first + order * kPi);
			// Of some rays below the photon sphere neither end is at infinity: see disk_crossing.h.
			if (!(r > 1.05 && r < 100.0) || std::isnan(exact.disk(view, order).r)) {
				continue;
			}
			const ShaderDisk::Crossing found = meetings.at(order);
			ASSERT_TRUE(found.reached)
					<< "trial " << trial << " order " << order << " u " << view.u << " r " << r;
			ASSERT_EQ(found.outgoing, sight.is_outgoing()) << "trial " << trial;
			ASSERT_NEAR(found.delay, sight.delay(), 1e-2) << "trial " << trial << " order " << order << " u "
														  << view.u << " r " << r << " xi " << view.xi;
			++seen[found.outgoing ? 0 : (slope > 0.0 ? 1 : 2)];
		}
	}
	EXPECT_GT(seen[0], 200); // leaves the disk on its way out
	EXPECT_GT(seen[1], 100); // on its way in, and turns
	EXPECT_GT(seen[2], 200); // on its way in
}

} // namespace
} // namespace blackhole::test
