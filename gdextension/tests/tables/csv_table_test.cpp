// SPDX-License-Identifier: MIT
#include "lut_cli/csv_table.h"

#include <gtest/gtest.h>

namespace blackhole::test {
namespace {

TEST(CsvTable, FindsColumnsByHeader) {
	const auto table = CsvTable::parse(
			"\xEF\xBB\xBF# what it is\r\nb , a\r\n\r\n1e-3, 2\r\n# between\r\n+4,5.5\n7,8,9", "t.csv");
	ASSERT_TRUE(table) << table.error;
	EXPECT_EQ(*table.value->column("a", true).value, (std::vector<double>{2.0, 5.5, 8.0}));
	EXPECT_EQ(*table.value->column("b", true).value, (std::vector<double>{1e-3, 4.0, 7.0}));
	EXPECT_EQ(table.value->line_of(1), 6U);
}

TEST(CsvTable, NamesFileLineAndColumnOfFaults) {
	const auto table = CsvTable::parse("a,b\n1,2\n3,x\n4\n5,nan\n6,1e999\n", "t.csv");
	ASSERT_TRUE(table);
	EXPECT_TRUE(table.value->column("a", true));
	EXPECT_EQ(table.value->column("b", true).error, "t.csv line 3: b is no number: 'x'");
	EXPECT_EQ(table.value->column("c", true).error, "t.csv: column c is missing in the header line");
	const auto few = CsvTable::parse("a,b\n4\n", "t.csv");
	EXPECT_EQ(few.value->column("b", true).error, "t.csv line 2: no cell for column b");
	const auto nan = CsvTable::parse("a\nnan\n", "t.csv");
	EXPECT_TRUE(nan.value->column("a", false));
	EXPECT_EQ(nan.value->column("a", true).error, "t.csv line 2: a must be finite, not nan");
	const auto huge = CsvTable::parse("a\n1e999\n", "t.csv");
	EXPECT_FALSE(huge.value->column("a", false));
}

TEST(CsvTable, NeedsAHeader) {
	EXPECT_FALSE(CsvTable::parse("", "t.csv"));
	EXPECT_FALSE(CsvTable::parse("# only a comment\n\n", "t.csv"));
	EXPECT_FALSE(CsvTable::load("/no/such/file.csv"));
	EXPECT_FALSE(CsvTable::load("/"));
}

} // namespace
} // namespace blackhole::test
