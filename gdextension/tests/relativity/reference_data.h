// SPDX-License-Identifier: MIT
#pragma once

#include "lut_cli/csv_table.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace blackhole::test {

/// Columns of one reference file in tests/data (50-digit values; the first line of each file defines them).
class ReferenceData {
public:
	explicit ReferenceData(const std::string &name) {
		Outcome<CsvTable> read = CsvTable::load(std::string(BLACKHOLE_TEST_DATA) + "/" + name + ".csv");
		EXPECT_TRUE(read) << read.error;
		table = std::move(*read.value);
	}

	[[nodiscard]] std::vector<double> column(const std::string &header) const {
		const Outcome<std::vector<double>> numbers = table.column(header, false);
		EXPECT_TRUE(numbers) << numbers.error;
		return numbers ? *numbers.value : std::vector<double>();
	}
	[[nodiscard]] std::size_t size() const { return table.row_count(); }

private:
	CsvTable table;
};

/// |found/expected - 1|.
inline double relative_error(double found, double expected) {
	return std::abs(found / expected - 1.0);
}

} // namespace blackhole::test
