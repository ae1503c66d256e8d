// SPDX-License-Identifier: MIT
#include "fuzz/star_table_checks.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/catalogue/plain_text.h"
#include "core/catalogue/star_file.h"
#include "fuzz/demand.h"

namespace blackhole::fuzz {

namespace {

/// A .stars file has angles in steps of 2^-32 of a turn.
constexpr double kHalfStep = std::numbers::pi / 4294967296.0 * 1.0001;

bool unknown_or_in(float p_value, const Range &p_range) {
	return std::isnan(p_value) || p_range.holds(p_value);
}

bool same(float p_first, float p_second) {
	return p_first == p_second || (std::isnan(p_first) && std::isnan(p_second));
}

bool same_turn(double p_first, double p_second, double p_tolerance) {
	return std::abs(std::remainder(p_first - p_second, 2.0 * std::numbers::pi)) <= p_tolerance;
}

} // namespace

void demand_sound(const StarTable &p_table) {
	demand(!p_table.stars.empty(), "an accepted catalogue has stars");
	demand(p_table.count_to(kMagnitudes.most) == p_table.stars.size(), "count_to finds all");
	float last = p_table.stars.front().v_magnitude;
	for (const Star &star : p_table.stars) {
		demand(star.right_ascension >= 0.0 && star.right_ascension <= 2.0 * std::numbers::pi,
				"right ascension is in a turn");
		demand(std::abs(star.declination) <= 0.5 * std::numbers::pi, "declination is in a half turn");
		demand(kMagnitudes.holds(star.v_magnitude) && star.v_magnitude >= last, "brightest first");
		demand(kTemperatures.holds(star.temperature_k), "temperature in its range");
		demand(unknown_or_in(star.b_minus_v, kColourIndices), "B-V in its range");
		demand(unknown_or_in(star.parallax_mas, kParallaxes), "parallax in its range");
		demand(star.name < p_table.names.size(), "the name is there");
		demand(is_plain_text(p_table.name_of(star)), "the name is text");
		last = star.v_magnitude;
	}
}

void demand_same(const StarTable &p_first, const StarTable &p_second, double p_tolerance) {
	demand(p_first.stars.size() == p_second.stars.size(), "as many stars");
	for (std::size_t i = 0; i < p_first.stars.size(); ++i) {
		const Star &a = p_first.stars[i];
		const Star &b = p_second.stars[i];
		demand(same_turn(a.right_ascension, b.right_ascension, p_tolerance), "same right ascension");
		demand(std::abs(a.declination - b.declination) <= p_tolerance, "same declination");
		demand(same(a.v_magnitude, b.v_magnitude) && same(a.b_minus_v, b.b_minus_v), "same light");
		demand(same(a.temperature_k, b.temperature_k), "same temperature");
		demand(same(a.parallax_mas, b.parallax_mas) && a.hip == b.hip, "same parallax and number");
		demand(p_first.name_of(a) == p_second.name_of(b), "same name");
	}
}

void demand_round_trip(const StarTable &p_table) {
	const std::vector<std::uint8_t> bytes = write_star_file(p_table);
	const auto again = read_star_file(bytes, "again.stars");
	demand(bool{again}, "what was written is read: " + again.error);
	demand_same(p_table, *again.value, kHalfStep);
	demand(write_star_file(*again.value) == bytes, "what was read is written the same");
}

} // namespace blackhole::fuzz
