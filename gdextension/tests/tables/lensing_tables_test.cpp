// SPDX-License-Identifier: MIT
#include "core/tables/lensing_tables.h"

#include "core/relativity/baseline.h"
#include "core/relativity/image_direction.h"
#include "core/relativity/orbital_angle.h"
#include "core/tables/table_axis.h"
#include "lut_cli/files.h"
#include "lut_cli/table_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace blackhole::test {
namespace {

const LensingTables &baked() {
	static const LensingTables tables = bake_lensing_tables();
	return tables;
}

float texel(const std::vector<float> &table, int column, int row, int channel) {
	return table[static_cast<std::size_t>(4 * (row * baked().columns + column) + channel)];
}

/// R and Q themselves, at any place of the grid (column and row need not be whole).
double inverse_value(double column, double row) {
	const LensingTables &tables = baked();
	const double u =
			std::exp(tables.ln_u_min + row * (tables.ln_u_max - tables.ln_u_min) / (tables.rows - 1));
	const double s = 2.0 * column / (tables.columns - 1) - 1.0;
	const double w = baseline_width(u);
	const double s0 = std::sqrt(0.5 * w) * std::exp(5.0 * s / std::sqrt(1.0 - s * s));
	return image_direction(u, angle_of_baseline(w, s0)).y / s0;
}

double forward_value(double column, double row) {
	const LensingTables &tables = baked();
	const double u =
			std::exp(tables.ln_u_min + row * (tables.ln_u_max - tables.ln_u_min) / (tables.rows - 1));
	const double s = 2.0 * column / (tables.columns - 1) - 1.0;
	const double w = baseline_width(u);
	const double y = std::sqrt(0.5 * w) * std::exp(5.0 * s / std::sqrt(1.0 - s * s));
	return baseline(w, orbital_angle(u, y)).s0 / y;
}

TEST(LensingTables, KeepWithinTheirErrors) {
	for (const TableError &error : measure_table_errors(baked(), 60000, 20260)) {
		EXPECT_LE(error.largest, error.limit) << error.name << " at u " << error.u << " Phi " << error.phi;
		EXPECT_GT(error.largest, 0.0) << error.name;
	}
}

TEST(LensingTables, HoldTheFunctionAndItsDerivatives) {
	using Function = double (*)(double, double);
	const std::pair<const std::vector<float> &, Function> tables[] = {
			{baked().inverse, inverse_value}, {baked().forward, forward_value}};
	for (const auto &[table, value] : tables) {
		// Away from u = 2/3, where a step of the differences would meet the photon sphere's narrow structure.
		for (const int row : {0, 7, 40, 70, 95}) {
			for (const int column : {5, 20, 50, 63, 64, 80, 110}) {
				const double h = 0.02;
				const auto f = [&, function = value](
									   double dx, double dv) { return function(column + dx, row + dv); };
				const double dx = (f(h, 0.0) - f(-h, 0.0)) / (2.0 * h);
				const double dv = (f(0.0, h) - f(0.0, -h)) / (2.0 * h);
				const double dxv = (f(h, h) - f(-h, h) - f(h, -h) + f(-h, -h)) / (4.0 * h * h);
				EXPECT_NEAR(texel(table, column, row, 0), f(0.0, 0.0), 1e-7 * f(0.0, 0.0))
						<< column << " " << row;
				EXPECT_NEAR(texel(table, column, row, 1), dx, 1e-4 * std::abs(dx) + 1e-8)
						<< column << " " << row;
				EXPECT_NEAR(texel(table, column, row, 2), dv, 1e-4 * std::abs(dv) + 1e-8)
						<< column << " " << row;
				EXPECT_NEAR(texel(table, column, row, 3), dxv, 2e-2 * std::abs(dxv) + 1e-6)
						<< column << " " << row;
			}
		}
	}
}

TEST(LensingTables, ReachTheirLimitsAtTheEnds) {
	for (int row = 0; row < baked().rows; ++row) {
		EXPECT_NEAR(texel(baked().inverse, 0, row, 0), 0.4353, 1e-4) << row;
		EXPECT_NEAR(texel(baked().inverse, 127, row, 0), 1.0, 1e-6) << row;
		EXPECT_NEAR(texel(baked().forward, 0, row, 0), 1.0 / 0.4353, 5e-4) << row;
		EXPECT_NEAR(texel(baked().forward, 127, row, 0), 1.0, 1e-6) << row;
		for (const int column : {0, 127}) {
			EXPECT_EQ(texel(baked().inverse, column, row, 1), 0.0F);
			EXPECT_EQ(texel(baked().forward, column, row, 1), 0.0F);
		}
	}
}

TEST(LensingTables, ReportProgressAndCancel) {
	double last = -1.0;
	int calls = 0;
	const LensingTables whole = bake_lensing_tables([&](double done) {
		EXPECT_GT(done, last);
		last = done;
		++calls;
		return true;
	});
	EXPECT_EQ(last, 1.0);
	EXPECT_GT(calls, 10);
	EXPECT_EQ(whole.inverse, baked().inverse);
	for (const double part : {0.3, 0.8}) {
		const LensingTables cancelled = bake_lensing_tables([part](double done) { return done < part; });
		EXPECT_EQ(cancelled.columns, 0);
		EXPECT_TRUE(cancelled.inverse.empty());
	}
}

TEST(LensingTables, CommittedFileIsAFreshBake) {
	const auto stored = load_table_file(std::string(BLACKHOLE_PROJECT_ROOT) + "/lut/schwarzschild.lut");
	ASSERT_TRUE(stored) << stored.error;
	const auto expect_same = [](const std::vector<float> &found, const std::vector<float> &expected) {
		ASSERT_EQ(found.size(), expected.size());
		for (std::size_t i = 0; i < expected.size(); ++i) {
			// Mathematical libraries may round the last digit differently.
			ASSERT_NEAR(found[i], expected[i], 2.4e-7 * std::abs(expected[i]) + 1e-9);
		}
	};
	expect_same(stored.value->inverse, baked().inverse);
	expect_same(stored.value->forward, baked().forward);
	expect_same(stored.value->rays.radius, baked().rays.radius);
	expect_same(stored.value->rays.delay, baked().rays.delay);
}

TEST(Baseline, AndItsInverseAgree) {
	for (const double w : {1e-12, 1e-3, 0.7}) {
		for (const double phi : {1e-5, 1.0, 3.14, 3.15, 6.0, 25.0, 200.0}) {
			// Near pi the angle is known to the rounding of t against sqrt(w).
			EXPECT_NEAR(angle_of_baseline(w, baseline(w, phi).s0), phi, 1e-14 * phi);
		}
	}
}

} // namespace
} // namespace blackhole::test
