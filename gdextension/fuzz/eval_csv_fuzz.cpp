// SPDX-License-Identifier: MIT
// The inputs of `blackhole-lut eval`. The first byte chooses the reference table, the rest is the CSV file.
// Rows that are accepted are evaluated exactly: each has all of its columns, however far out the numbers are.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/demand.h"
#include "lut_cli/csv_table.h"
#include "lut_cli/reference_columns.h"

namespace {

using namespace blackhole;

constexpr std::size_t kMostRows = 2;

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *p_data, std::size_t p_size) {
	if (p_size == 0) {
		return 0;
	}
	const auto &kinds = reference_kinds();
	const ReferenceKind &kind = kinds[p_data[0] % kinds.size()];
	const std::string_view text(reinterpret_cast<const char *>(p_data) + 1, p_size - 1);
	const auto table = CsvTable::parse(text, "in.csv");
	if (!table) {
		fuzz::demand_reason(table.error, "in.csv");
		return 0;
	}
	const auto rows = reference_inputs(kind, *table.value);
	if (!rows) {
		fuzz::demand_reason(rows.error, "in.csv");
		return 0;
	}
	const ExactRays rays;
	for (std::size_t row = 0; row < std::min(rows.value->size(), kMostRows); ++row) {
		const auto found = kind.evaluate(rays, (*rows.value)[row]);
		fuzz::demand(found.size() == kind.columns.size(), "a row of results has all columns");
	}
	return 0;
}
