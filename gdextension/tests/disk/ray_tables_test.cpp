// SPDX-License-Identifier: MIT
#include "core/tables/ray_tables.h"

#include "core/disk/ray_radius.h"
#include "core/relativity/critical.h"
#include "core/tables/ray_axis.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>
#include <cstddef>

namespace blackhole::test {
namespace {

const RayTables &baked() {
	static const RayTables tables = bake_ray_tables();
	return tables;
}

float texel(const std::vector<float> &table, bool turns, int column, int row, int channel) {
	const int line = turns ? row : kRayHalfRows + row;
	return table[static_cast<std::size_t>(4 * (line * kRayColumns + column) + channel)];
}

/// A ray and a place on it, by the grid (column and row need not be whole).
struct Node {
	double a;
	double epsilon;
	double eta;

	Node(bool turns, double column, double row) {
		const double nearness =
				kRayBend * std::expm1(column / (kRayColumns - 1.0) * std::log1p(kRayNearest / kRayBend));
		const double rest = std::exp(-nearness);
		a = turns ? kCriticalA * (1.0 - rest) : kCriticalA / (1.0 - rest);
		epsilon = turns ? kCriticalA * kCriticalA * rest * (2.0 - rest) : -a * a * rest * (2.0 - rest);
		eta = ray_span(turns, nearness).eta * row / (kRayHalfRows - 1.0);
	}
	double radius_ratio() const { return std::sqrt(a * eta / inverse_radius_on_ray(a, epsilon, eta, 1e3)); }
	double delay_ratio() const {
		const auto pace = [this](double at) {
			const double u = at > 0.0 ? inverse_radius_on_ray(a, epsilon, at, 1e3) : 0.0;
			return 1.0 / (a + std::sqrt(std::max(a * a - u * u * (1.0 - u), 0.0)));
		};
		const double spent =
				boost::math::quadrature::gauss_kronrod<double, 15>::integrate(pace, 0.0, eta, 6, 1e-11);
		return 2.0 * a * spent / eta;
	}
};

/// Rows before the turning point, which the exact solution does not pass.
constexpr int kRows[] = {1, 7, 20, 40, 51};
constexpr int kColumns[] = {1, 5, 20, 50, 75, 93};

TEST(RayTables, HoldTheRadius) {
	for (const bool turns : {true, false}) {
		for (const int row : kRows) {
			for (const int column : kColumns) {
				const double expected = Node(turns, column, row).radius_ratio();
				EXPECT_NEAR(texel(baked().radius, turns, column, row, 0), expected, 3e-7)
						<< turns << ' ' << column << ' ' << row;
			}
		}
	}
}

TEST(RayTables, HoldTheDelay) {
	for (const bool turns : {true, false}) {
		for (const int row : kRows) {
			for (const int column : kColumns) {
				const double expected = Node(turns, column, row).delay_ratio();
				EXPECT_NEAR(texel(baked().delay, turns, column, row, 0), expected, 1e-6)
						<< turns << ' ' << column << ' ' << row;
			}
		}
	}
}

TEST(RayTables, HoldTheDerivatives) {
	const double h = 0.02;
	for (const bool turns : {true, false}) {
		for (const int row : {7, 20, 40}) {
			for (const int column : {2, 5, 20, 50, 75}) {
				const auto f = [&](double dc, double dr) {
					return Node(turns, column + dc, row + dr).radius_ratio();
				};
				const double by_column = (f(h, 0.0) - f(-h, 0.0)) / (2.0 * h);
				const double by_row = (f(0.0, h) - f(0.0, -h)) / (2.0 * h);
				const double mixed = (f(h, h) - f(-h, h) - f(h, -h) + f(-h, -h)) / (4.0 * h * h);
				const auto at = [&](int channel) {
					return texel(baked().radius, turns, column, row, channel);
				};
				EXPECT_NEAR(at(1), by_column, 2e-7 + 1e-4 * std::abs(by_column))
						<< turns << column << ' ' << row;
				EXPECT_NEAR(at(2), by_row, 2e-7 + 1e-4 * std::abs(by_row)) << turns << column << ' ' << row;
				EXPECT_NEAR(at(3), mixed, 2e-6 + 4e-2 * std::abs(mixed)) << turns << column << ' ' << row;
			}
		}
	}
}

TEST(RayTables, StartWithStraightLight) {
	for (const bool turns : {true, false}) {
		for (int column = 0; column < kRayColumns; ++column) {
			EXPECT_EQ(texel(baked().radius, turns, column, 0, 0), 1.0F);
			EXPECT_EQ(texel(baked().delay, turns, column, 0, 0), 1.0F);
			EXPECT_EQ(texel(baked().radius, turns, column, 0, 2), 0.0F);
		}
	}
	// Without a hole: u = a sin eta, and the turning point is where the last row of that column is.
	const int last = kRayHalfRows - 1;
	EXPECT_NEAR(texel(baked().radius, true, 0, last, 0), std::sqrt(0.5 * 3.14159265358979), 1e-6);
}

} // namespace
} // namespace blackhole::test
