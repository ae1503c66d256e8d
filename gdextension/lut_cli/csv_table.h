// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"

#include <string>
#include <string_view>
#include <vector>

namespace blackhole {

/// A comma-separated table with a header line. Lines that start with # and empty lines are skipped; cells
/// stay text until a column is asked for, so that columns nobody needs may hold anything.
class CsvTable {
public:
	/// Parses `text`; `name` is used in messages. Fails without a header line.
	static Outcome<CsvTable> parse(std::string_view text, const std::string &name);
	/// Reads the file at `path` and parses it.
	static Outcome<CsvTable> load(const std::string &path);

	/// The numbers of the column with this header. Fails, naming file, line and column, where the column or a
	/// cell is missing or a cell is no number; with `finite` also for nan and infinities.
	[[nodiscard]] Outcome<std::vector<double>> column(const std::string &header, bool finite) const;

	[[nodiscard]] std::size_t row_count() const { return rows.size(); }
	/// Line number in the file (from 1) of the row with this index.
	[[nodiscard]] std::size_t line_of(std::size_t row) const { return rows[row].line; }
	[[nodiscard]] const std::string &name() const { return table_name; }

private:
	struct Row {
		std::size_t line = 0;
		std::vector<std::string> cells;
	};
	std::string table_name;
	std::vector<std::string> headers;
	std::vector<Row> rows;
};

} // namespace blackhole
