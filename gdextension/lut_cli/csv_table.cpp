// SPDX-License-Identifier: MIT
#include "lut_cli/csv_table.h"

#include "lut_cli/files.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace blackhole {
namespace {

/// Larger inputs are a mistake rather than a table.
constexpr std::size_t kLargestCsv = std::size_t{1} << 30;

std::string_view trim(std::string_view text) {
	const auto begin = text.find_first_not_of(" \t\r");
	if (begin == std::string_view::npos) {
		return {};
	}
	return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string> split(std::string_view line) {
	std::vector<std::string> cells;
	while (true) {
		const auto comma = line.find(',');
		cells.emplace_back(trim(line.substr(0, comma)));
		if (comma == std::string_view::npos) {
			return cells;
		}
		line.remove_prefix(comma + 1);
	}
}

bool parse_number(std::string_view cell, double &number) {
	if (cell.starts_with('+')) {
		cell.remove_prefix(1);
	}
	const char *end = cell.data() + cell.size();
	const auto [rest, code] = std::from_chars(cell.data(), end, number);
	return code == std::errc() && rest == end && !cell.empty();
}

} // namespace

Outcome<CsvTable> CsvTable::parse(std::string_view text, const std::string &name) {
	CsvTable table;
	table.table_name = name;
	if (text.starts_with("\xEF\xBB\xBF")) {
		text.remove_prefix(3); // byte order mark
	}
	for (std::size_t line = 1; !text.empty(); ++line) {
		const auto newline = text.find('\n');
		const std::string_view content = trim(text.substr(0, newline));
		text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
		if (content.empty() || content.starts_with('#')) {
			continue;
		}
		if (table.headers.empty()) {
			table.headers = split(content);
		} else {
			table.rows.push_back({line, split(content)});
		}
	}
	if (table.headers.empty()) {
		return Outcome<CsvTable>::failure(name +
				": no header line; the first line that is not a # comment must "
				"name the columns");
	}
	return Outcome<CsvTable>::success(std::move(table));
}

Outcome<CsvTable> CsvTable::load(const std::string &path) {
	const Outcome<std::string> text = read_file(path, kLargestCsv);
	if (!text) {
		return Outcome<CsvTable>::failure(text.error);
	}
	return parse(*text.value, path);
}

Outcome<std::vector<double>> CsvTable::column(const std::string &header, bool finite) const {
	using Result = Outcome<std::vector<double>>;
	const auto found = std::find(headers.begin(), headers.end(), header);
	if (found == headers.end()) {
		return Result::failure(table_name + ": column " + header + " is missing in the header line");
	}
	const auto index = static_cast<std::size_t>(found - headers.begin());
	std::vector<double> numbers;
	numbers.reserve(rows.size());
	const auto failure = [this](const Row &row, const std::string &reason) {
		return Result::failure(table_name + " line " + std::to_string(row.line) + ": " + reason);
	};
	for (const Row &row : rows) {
		if (index >= row.cells.size()) {
			return failure(row, "no cell for column " + header);
		}
		double number = 0.0;
		if (!parse_number(row.cells[index], number)) {
			return failure(row, header + " is no number: '" + row.cells[index] + "'");
		}
		if (finite && !std::isfinite(number)) {
			return failure(row, header + " must be finite, not " + row.cells[index]);
		}
		numbers.push_back(number);
	}
	return Result::success(std::move(numbers));
}

} // namespace blackhole
