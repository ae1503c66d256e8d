// SPDX-License-Identifier: MIT
#include "core/disk/disk_crossing.h"

#include "core/relativity/critical.h"
#include "core/relativity/view_angle.h"
#include "lut_cli/reference_columns.h"
#include "relativity/reference_data.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace blackhole::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Light that looks almost along the plane reaches it far out, at an angle that is a small difference.
constexpr double kRadiusTolerance = 2e-11;
constexpr double kRedshiftTolerance = 2e-12;

class HighOrders : public testing::TestWithParam<std::string> {};

TEST_P(HighOrders, AgreeWithTheReference) {
	const ReferenceData data("disk_high_" + GetParam());
	const ReferenceKind *kind = find_reference_kind("disk_" + GetParam());
	ASSERT_EQ(data.size(), 200U);
	std::vector<std::vector<double>> columns;
	for (const std::string &header : kind->columns) {
		columns.push_back(data.column(header));
	}
	for (std::size_t row = 0; row < data.size(); ++row) {
		const std::array<double, 4> inputs{
				columns[0][row], columns[1][row], columns[2][row], columns[3][row]};
		const std::vector<double> found = kind->evaluate(ExactRays(), inputs);
		for (std::size_t i = inputs.size(); i < columns.size(); ++i) {
			const double expected = columns[i][row];
			ASSERT_EQ(std::isnan(found[i]), std::isnan(expected)) << kind->columns[i] << " row " << row;
			if (!std::isnan(expected)) {
				const bool radius = kind->columns[i].front() == 'r';
				EXPECT_LT(relative_error(found[i], expected), radius ? kRadiusTolerance : kRedshiftTolerance)
						<< kind->columns[i] << " row " << row;
			}
		}
	}
}

INSTANTIATE_TEST_SUITE_P(
		Files, HighOrders, testing::Values("static", "rain"), [](const auto &test) { return test.param; });

/// Where a line of sight meets the plane, by integrating u'' = 3/2 u^2 - u over the orbital angle:
/// independent of every elliptic integral.
class IntegratedSight {
public:
	IntegratedSight(double p_u, double slope) : deepest(std::max(1.0, p_u)), state{p_u, slope} {}

	/// r at the orbital angle chi [rad], NaN where the way has ended before. Angles must rise.
	double radius_at(double chi) {
		while (at < chi && !ended) {
			const double natural = 0.02 / std::sqrt(1.0 + state[0] + std::abs(state[1]));
			const double step = std::min(natural, chi - at);
			stepper.do_step(orbit_equation, state, at, step);
			at = step == natural ? at + step : chi;
			ended = !(state[0] > 0.0 && state[0] < deepest);
		}
		return ended ? std::numeric_limits<double>::quiet_NaN() : 1.0 / state[0];
	}
	/// How near to its end the way is, in u.
	double margin() const { return std::min(std::abs(state[0]), std::abs(deepest - state[0])); }

private:
	using State = std::array<double, 2>;
	static void orbit_equation(const State &state, State &slope, double /*phi*/) {
		slope = {state[1], 1.5 * state[0] * state[0] - state[0]};
	}

	boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
	double deepest;
	State state;
	double at = 0.0;
	bool ended = false;
};

TEST(DiskCrossing, AgreesWithAnIntegratorForObserversAnywhere) {
	std::mt19937_64 random(5);
	const auto uniform = [&random](double low, double high) {
		return std::uniform_real_distribution<double>(low, high)(random);
	};
	int hits = 0;
	int below = 0;
	for (int trial = 0; trial < 100000; ++trial) {
		const double u = std::exp(uniform(std::log(0.01), std::log(10.0)));
		const double xi = uniform(0.02, kPi - 0.02);
		const double y = rain_sigma_offset(u, xi);
		const double sigma = critical_sigma(u) + y;
		const bool inward = sigma * sigma < 1.0 - u;
		if (y <= 0.0 && !(inward && (1.0 - u) / sigma > critical_sigma(u))) {
			continue; // neither end at infinity: see disk_crossing.h
		}
		const DiskSight sight{u, y, uniform(0.0, kPi), uniform(-kPi, kPi)};
		const double slope = u * (std::cos(xi) - std::sqrt(u)) / std::sin(xi);
		// The plane is met where the way, turned by chi from the observer, is square to N.
		const glm::dvec3 normal(std::sin(sight.inclination), 0.0, std::cos(sight.inclination));
		const glm::dvec3 azimuth(std::cos(sight.azimuth), std::sin(sight.azimuth), 0.0);
		double chi = std::atan2(-normal.z, glm::dot(azimuth, normal));
		chi = chi < 0.0 ? chi + kPi : chi;
		IntegratedSight integrated(u, slope);
		for (int order = 0; order < 4; ++order) {
			const double expected = integrated.radius_at(chi + order * kPi);
			const double found = disk_crossing_radius(sight, order);
			if (integrated.margin() < 1e-6) {
				continue; // on the very end: neither is wrong
			}
			ASSERT_EQ(std::isnan(found), std::isnan(expected))
					<< "u " << u << " xi " << xi << " order " << order << " r " << expected << ' ' << found;
			if (!std::isnan(expected)) {
				// Errors of direction grow with exp(chi).
				ASSERT_LT(relative_error(found, expected), 1e-9 * std::exp(kPi * order)) << order;
				++hits;
				below += sight.inclination > 0.5 * kPi ? 1 : 0;
			}
		}
	}
	EXPECT_GT(hits, 30000);
	EXPECT_GT(below, 15000);
}

TEST(DiskRedshift, IsThatOfTheCircularOrbit) {
	// Seen face on: time dilation of the orbit alone.
	EXPECT_DOUBLE_EQ(disk_redshift(6.0, 0.2, 0.0, 1.0), std::sqrt(1.0 - 1.5 / 6.0));
	// Receding to the right of the axis, approaching to the left.
	EXPECT_LT(disk_redshift(6.0, 0.2, 1.4, 1.5), disk_redshift(6.0, 0.2, 1.4, -1.5));
	EXPECT_TRUE(std::isnan(disk_redshift(1.4, 0.2, 1.0, 1.0)));
}

} // namespace
} // namespace blackhole::test
