// SPDX-License-Identifier: MIT
// Every column of every reference file, exactly and through the tables.
#include "core/tables/lensing_tables.h"
#include "lut_cli/reference_columns.h"
#include "relativity/reference_data.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace blackhole::test {
namespace {

/// Largest relative errors allowed. Inputs are doubles taken as exact. A direction is rounded as Phi is,
/// times the condition number d ln y/d ln Phi: about 100 where a far observer (u = 1e-4) looks past the hole,
/// hence 4e-14; all that does not go through the inversion keeps a few units of the last digit.
struct Tolerance {
	double exact;
	double tabulated;
};

const std::map<std::string, Tolerance> &tolerances() {
	constexpr double kRounding = 2e-15;
	constexpr double kInverted = 4e-14;
	constexpr double kInvertedSlope = 4e-13;
	static const std::map<std::string, Tolerance> table = {
			{"u_o", {0.0, 0.0}},
			{"b", {0.0, 0.0}},
			{"xi", {0.0, 0.0}},
			{"phi", {0.0, 0.0}},
			{"order", {0.0, 0.0}},
			{"n", {0.0, 0.0}},
			{"side", {0.0, 0.0}},
			// Directions and what follows from them.
			{"sigma", {kInverted, 1e-5}},
			{"sigma_minus_crit", {kInverted, 2e-5}},
			{"a", {kInverted, 2e-5}},
			{"xi_rain", {kInverted, 1e-5}},
			{"xi_static", {kInverted, 1e-5}},
			{"xi_rain_minus_shadow", {kInverted, 2e-5}},
			{"xi_static_minus_shadow", {kInverted, 2e-5}},
			{"dxi_rain_dPhi", {kInvertedSlope, 3e-3}},
			{"dxi_static_dPhi", {kInvertedSlope, 3e-3}},
			{"mu_rain", {kInvertedSlope, 3e-3}},
			{"mu_static", {kInvertedSlope, 3e-3}},
			{"g_rain", {kRounding, 2e-5}},
			{"g_static", {kRounding, kRounding}},
			// Forward: no inversion; the difference from the shadow is formed in quadruple precision.
			{"xi_minus_shadow", {kRounding, kRounding}},
			{"Phi", {3e-15, 1e-5}},
			{"dPhi_dxi", {4e-14, 3e-3}},
			{"xi_shadow_rain", {kRounding, kRounding}},
			{"xi_shadow_static", {kRounding, kRounding}},
			// The strong limit crosses zero: 1e-15 absolute is 2e-13 relative in the worst row.
			{"b_over_bc_minus_1", {kRounding, kRounding}},
			{"alpha", {1e-14, 1e-14}},
			{"alpha_weak4", {kRounding, kRounding}},
			{"alpha_strong", {4e-13, 4e-13}},
			{"r_min", {kRounding, kRounding}},
			{"v_circ", {kRounding, kRounding}},
			// Close to the photon sphere 1/(2 - 3 u) amplifies the rounding of a boost in its direction's
			// cosine.
			{"d1", {2e-12, 2e-12}},
			{"g_circ", {1e-13, 1e-13}},
			// Light that looks almost along the disk's plane reaches it far out, at an angle that is a small
			// difference; directions are rounded, the more often the light goes round the hole the worse.
			{"r0", {2e-11, 5e-4}},
			{"r1", {2e-12, 5e-3}},
			{"r2", {2e-12, 3e-2}},
			{"g0", {2e-12, 1e-3}},
			{"g1", {2e-12, 5e-3}},
			{"g2", {2e-12, 3e-2}},
			{"F_shape", {kRounding, kRounding}},
			{"F_rel", {kRounding, kRounding}},
			{"T_rel", {kRounding, kRounding}},
			// Light that goes the gas's way nearly cancels: a factor of 500 deep within.
			{"redshift", {1e-13, 1e-13}},
	};
	return table;
}

/// Files of difficult rows are of the same kind as the others.
std::string kind_of(std::string name) {
	const std::string difficult = "_high";
	const std::size_t at = name.find(difficult);
	return at == std::string::npos ? name : name.erase(at, difficult.size());
}

/// Next to r = 1.5 an orbit's speed nears that of light, and the rounding of r grows in its frequency.
double orbit_room(double r) {
	return std::max(1.0, 0.02 / (r - 1.5));
}

void compare(const std::string &name, const RaySource &rays, double Tolerance::*which) {
	const ReferenceKind *kind = find_reference_kind(kind_of(name));
	ASSERT_NE(kind, nullptr);
	const ReferenceData data(name);
	ASSERT_GE(data.size(), 200U);
	std::vector<std::vector<double>> columns;
	for (const std::string &header : kind->columns) {
		columns.push_back(data.column(header));
	}
	std::vector<double> worst(columns.size(), 0.0);
	for (std::size_t row = 0; row < data.size(); ++row) {
		std::vector<double> inputs;
		for (std::size_t i = 0; i < kind->input_count; ++i) {
			inputs.push_back(columns[i][row]);
		}
		ASSERT_EQ(kind->reject(inputs), "");
		const std::vector<double> found = kind->evaluate(rays, inputs);
		ASSERT_EQ(found.size(), columns.size());
		for (std::size_t i = 0; i < columns.size(); ++i) {
			const double expected = columns[i][row];
			ASSERT_EQ(std::isnan(found[i]), std::isnan(expected)) << kind->columns[i] << " row " << row;
			if (!std::isnan(expected) && found[i] != expected) {
				const double room =
						kind->columns[i].starts_with("g") && i > 0 && kind->columns[i - 1].starts_with("r")
						? orbit_room(columns[i - 1][row])
						: 1.0;
				worst[i] = std::max(worst[i], relative_error(found[i], expected) / room);
			}
		}
	}
	for (std::size_t i = 0; i < columns.size(); ++i) {
		const double limit = i < kind->input_count ? 0.0 : tolerances().at(kind->columns[i]).*which;
		EXPECT_LE(worst[i], limit) << name << " " << kind->columns[i];
	}
}

class ReferenceColumns : public testing::TestWithParam<std::string> {};

TEST_P(ReferenceColumns, ExactValuesAgree) {
	compare(GetParam(), ExactRays(), &Tolerance::exact);
}

TEST_P(ReferenceColumns, TabulatedValuesAgree) {
	static const LensingTables tables = bake_lensing_tables();
	compare(GetParam(), TabulatedRays(tables), &Tolerance::tabulated);
}

INSTANTIATE_TEST_SUITE_P(Files, ReferenceColumns,
		testing::Values("inverse_static", "inverse_rain", "forward_static", "forward_rain", "images", "rings",
				"shadow", "deflection", "gshift", "disk_static", "disk_rain", "disk_high_static",
				"disk_high_rain", "page_thorne", "plunging_gas"),
		[](const auto &test) { return test.param; });

} // namespace
} // namespace blackhole::test
