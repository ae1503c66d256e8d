// SPDX-License-Identifier: MIT
// The core's formula and the shader's against vectors that tools/reference/plunging_gas.py integrated.
#include "core/disk/plunging_gas.h"

#include "core/disk/disk_crossing.h"
#include "core/tables/lensing_shader.h"
#include "relativity/reference_data.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace blackhole::test {
namespace {

struct Emission {
	double r;
	EmittedLight light;
	double redshift;
};

std::vector<Emission> emissions() {
	const ReferenceData data("plunging_gas");
	const std::vector<double> r = data.column("r");
	const std::vector<double> a = data.column("a");
	const std::vector<double> tilt = data.column("tilt");
	const std::vector<double> outgoing = data.column("outgoing");
	const std::vector<double> redshift = data.column("redshift");
	std::vector<Emission> rows;
	for (std::size_t row = 0; row < data.size(); ++row) {
		rows.push_back({r[row], {a[row], tilt[row], outgoing[row] == 1.0}, redshift[row]});
	}
	return rows;
}

double shader_redshift(double r, const EmittedLight &light) {
	return lensing_shader::plunge_redshift(static_cast<float>(1.0 / r), static_cast<float>(light.a),
			static_cast<float>(light.tilt / light.a), light.outgoing);
}

TEST(PlungingGas, AgreesWithIntegratedGeodesics) {
	const std::vector<Emission> rows = emissions();
	ASSERT_GE(rows.size(), 200U);
	int outgoing = 0;
	for (const Emission &row : rows) {
		const double found = plunging_redshift(row.r, row.light);
		EXPECT_LT(relative_error(found, row.redshift), 1e-13)
				<< "r " << row.r << " a " << row.light.a << " tilt " << row.light.tilt;
		outgoing += row.light.outgoing ? 1 : 0;
	}
	EXPECT_GT(outgoing, 70);
}

TEST(PlungingGas, AgreesInTheShader) {
	for (const Emission &row : emissions()) {
		EXPECT_LT(relative_error(shader_redshift(row.r, row.light), row.redshift), 1e-4)
				<< "r " << row.r << " a " << row.light.a << " tilt " << row.light.tilt;
	}
}

TEST(PlungingGas, StartsAsTheLastStableOrbit) {
	for (const double a : {0.28, 0.4, 2.0}) {
		for (const double tilt : {-1.0, -0.3, 0.0, 1.0}) {
			for (const bool outgoing : {false, true}) {
				const EmittedLight light{a, tilt, outgoing};
				// tilt = sin(inclination) sin(azimuth)
				const double orbit = disk_redshift(3.0, a, 0.5 * std::numbers::pi, std::asin(tilt));
				EXPECT_NEAR(plunging_redshift(3.0, light) / orbit, 1.0, 1e-14) << a << " " << tilt;
				EXPECT_NEAR(shader_redshift(3.0, light) / orbit, 1.0, 1e-6) << a << " " << tilt;
				// It sets out slowly: the speed grows with the power 3/2 of the way.
				EXPECT_NEAR(plunging_redshift(3.0 - 1e-6, light) / orbit, 1.0, 3e-6) << a << " " << tilt;
			}
		}
	}
}

TEST(PlungingGas, GoesOnSmoothlyThroughTheHorizon) {
	for (const double a : {0.1, 0.4, 2.0}) {
		const EmittedLight light{a, 0.7, false};
		const double above = plunging_redshift(1.0 + 1e-7, light);
		const double at = plunging_redshift(1.0, light);
		const double below = plunging_redshift(1.0 - 1e-7, light);
		EXPECT_GT(at, 0.0);
		EXPECT_NEAR((above + below) / (2.0 * at), 1.0, 1e-10);
	}
}

TEST(PlungingGas, IsNoneWhereThereIsNoSuchGasOrLight) {
	constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
	EXPECT_TRUE(std::isnan(plunging_redshift(3.1, {0.4, 0.0, false})));
	EXPECT_TRUE(std::isnan(plunging_redshift(0.0, {0.4, 0.0, false})));
	EXPECT_TRUE(std::isnan(plunging_redshift(kNaN, {0.4, 0.0, false})));
	EXPECT_TRUE(std::isnan(plunging_redshift(1.0, {0.4, 0.0, true})));
	EXPECT_TRUE(std::isnan(plunging_redshift(0.5, {0.4, 0.0, true})));
}

} // namespace
} // namespace blackhole::test
