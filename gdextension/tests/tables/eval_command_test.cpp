// SPDX-License-Identifier: MIT
#include "lut_cli/eval_command.h"

#include "lut_cli/csv_table.h"
#include "lut_cli/files.h"
#include "lut_cli/table_commands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace blackhole::test {
namespace {

/// A folder of its own for each test, gone afterwards.
class EvalCommand : public testing::Test {
protected:
	void SetUp() override {
		const auto *test = testing::UnitTest::GetInstance()->current_test_info();
		folder = std::filesystem::temp_directory_path() / (std::string("blackhole_eval_") + test->name());
		std::filesystem::create_directories(folder);
	}
	void TearDown() override { std::filesystem::remove_all(folder); }

	std::string path(const std::string &name) const { return (folder / name).string(); }
	/// Runs eval on this text; returns its error message.
	std::string eval(const std::string &name, const std::string &csv, const std::string &table = {}) const {
		EXPECT_EQ(write_file(path("in.csv"), csv), "");
		return run_eval(name, path("in.csv"), path("out.csv"), table);
	}
	double result(const std::string &column) const {
		const auto table = CsvTable::load(path("out.csv"));
		EXPECT_TRUE(table) << table.error;
		return table.value->column(column, false).value->at(0);
	}

	std::filesystem::path folder;
};

TEST_F(EvalCommand, ReadsInputsInAnyOrderAndIgnoresTheRest) {
	ASSERT_EQ(eval("inverse_static", "# words\nremark,Phi,u_o\nhello,3.141592653589793,0.1\n"), "");
	const double degrees = 180.0 / 3.141592653589793;
	EXPECT_NEAR(result("xi_static") * degrees, 29.8283179057, 1e-10);
	EXPECT_EQ(result("u_o"), 0.1);
	const auto text = read_file(path("out.csv"), 1 << 20);
	EXPECT_TRUE(text.value->starts_with(
			"u_o,Phi,sigma,sigma_minus_crit,a,xi_rain,xi_rain_minus_shadow,dxi_rain_dPhi,"
			"mu_rain,g_rain,xi_static,xi_static_minus_shadow,dxi_static_dPhi,mu_static\n"));
}

TEST_F(EvalCommand, WritesNanWhereThereIsNoObserverOrRay) {
	ASSERT_EQ(eval("shadow", "u_o\n1.5\n"), "");
	EXPECT_TRUE(std::isnan(result("xi_shadow_static")));
	EXPECT_GT(result("xi_shadow_rain"), 0.5);
	ASSERT_EQ(eval("forward_static", "u_o,xi_static\n0.1,0.01\n"), "");
	EXPECT_TRUE(std::isnan(result("Phi"))); // inside the shadow
	ASSERT_EQ(eval("deflection", "b\n2.5\n"), "");
	EXPECT_TRUE(std::isnan(result("alpha")));
}

TEST_F(EvalCommand, HandlesTheAxis) {
	ASSERT_EQ(eval("images", "u_o,phi,order\n0.1,0,0\n"), "");
	EXPECT_NEAR(result("xi_rain"), 3.141592653589793, 1e-15);
	EXPECT_TRUE(std::isfinite(result("mu_rain")));
}

TEST_F(EvalCommand, TakesATable) {
	ASSERT_EQ(run_bake(path("t.lut"), ""), "");
	ASSERT_EQ(run_inspect(path("t.lut")), "");
	ASSERT_EQ(eval("rings", "u_o,n\n0.1,1\n"), "");
	const double exact = result("xi_rain");
	ASSERT_EQ(eval("rings", "u_o,n\n0.1,1\n", path("t.lut")), "");
	EXPECT_NE(result("xi_rain"), exact);
	EXPECT_NEAR(result("xi_rain"), exact, 1e-6);
	EXPECT_EQ(run_bake("", path("t.lut")), "");
}

TEST_F(EvalCommand, RefusesBadRowsByLine) {
	const auto expect = [this](const std::string &name, const std::string &csv, const std::string &part) {
		const std::string error = eval(name, csv);
		EXPECT_NE(error.find(part), std::string::npos) << error;
		EXPECT_FALSE(std::filesystem::exists(path("out.csv")));
	};
	expect("inverse_rain", "u_o,Phi\n0.1,1\n0,1\n", "line 3: u_o");
	expect("inverse_rain", "u_o,Phi\n0.1,-1\n", "line 2: Phi");
	expect("inverse_rain", "u_o,Phi\n0.1\n", "line 2: no cell for column Phi");
	expect("inverse_rain", "u_o\n0.1\n", "column Phi is missing");
	expect("forward_rain", "u_o,xi_rain\n0.1,3.2\n", "line 2: xi");
	expect("forward_rain", "u_o,xi_rain\n0.1,nan\n", "line 2: xi_rain must be finite");
	expect("images", "u_o,phi,order\n0.1,1,1.5\n", "line 2: order");
	expect("images", "u_o,phi,order\n0.1,4,1\n", "line 2: phi");
	expect("rings", "u_o,n\n0.1,0\n", "line 2: n");
	expect("deflection", "b\n-3\n", "line 2: b");
	expect("nonsense", "b\n3\n", "unknown reference table");
}

TEST_F(EvalCommand, RefusesBadFiles) {
	EXPECT_NE(run_eval("rings", path("none.csv"), path("out.csv"), "").find("cannot be opened"),
			std::string::npos);
	EXPECT_NE(eval("rings", "u_o,n\n0.1,1\n", path("none.lut")).find("cannot be opened"), std::string::npos);
	ASSERT_EQ(write_file(path("bad.lut"), "rubbish"), "");
	EXPECT_NE(eval("rings", "u_o,n\n0.1,1\n", path("bad.lut")).find("./run bake"), std::string::npos);
	EXPECT_NE(run_inspect(path("bad.lut")).find("bad.lut"), std::string::npos);
	EXPECT_NE(run_verify(path("bad.lut"), 10, 1).find("bad.lut"), std::string::npos);
	EXPECT_NE(run_bake("", path("bad.lut")).find("bad.lut"), std::string::npos);
	EXPECT_NE(run_bake("", ""), "");
	EXPECT_NE(run_eval("rings", path("in.csv"), path("no/such/folder/out.csv"), "").find("cannot be written"),
			std::string::npos);
}

} // namespace
} // namespace blackhole::test
