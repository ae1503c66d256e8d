// SPDX-License-Identifier: MIT
// The reader of star tables: what it accepts comes back the same from a .stars file and from a table of its
// own.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>

#include "core/catalogue/star_csv.h"
#include "fuzz/demand.h"
#include "fuzz/star_table_checks.h"

namespace {

using namespace blackhole;

/// In the fewest digits that lead back to the number; nothing for NaN, which stands for unknown.
template <class Number>
std::string digits(Number p_number) {
	if (std::isnan(p_number)) {
		return {};
	}
	char text[64];
	const auto end = std::to_chars(text, text + sizeof text, p_number).ptr;
	return {text, end};
}

std::string quoted(std::string_view p_text) {
	std::string text = "\"";
	for (const char c : p_text) {
		text += c == '"' ? "\"\"" : std::string(1, c);
	}
	return text + '"';
}

std::string as_csv(const StarTable &p_table) {
	std::string text = "ra_deg,dec_deg,vmag,bv,temperature_k,parallax_mas,hip,name\n";
	for (const Star &star : p_table.stars) {
		const double degrees = 180.0 / std::numbers::pi;
		text += digits(star.right_ascension * degrees) + ',' +
				digits(std::clamp(star.declination * degrees, -90.0, 90.0)) + ',' + digits(star.v_magnitude) +
				',' + digits(star.b_minus_v) + ',' + digits(star.temperature_k) + ',' +
				digits(star.parallax_mas) + ',' + std::to_string(star.hip) + ',' +
				quoted(p_table.name_of(star)) + '\n';
	}
	return text;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *p_data, std::size_t p_size) {
	const std::string_view text(reinterpret_cast<const char *>(p_data), p_size);
	const auto table = read_star_csv(text, "sky.csv");
	const std::string fault = star_csv_fault(text.substr(0, kStarCsvHead), "sky.csv");
	if (!table) {
		fuzz::demand_reason(table.error, "sky.csv");
		return 0;
	}
	fuzz::demand(fault.empty(), "the start of a good table is good");
	fuzz::demand_sound(*table.value);
	fuzz::demand_round_trip(*table.value);
	const auto again = read_star_csv(as_csv(*table.value), "again.csv");
	fuzz::demand(bool{again}, "what was written is read: " + again.error);
	fuzz::demand_same(*table.value, *again.value, 1e-14);
	return 0;
}
