// SPDX-License-Identifier: MIT
#include "core/catalogue/star_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/catalogue/csv_records.h"
#include "core/catalogue/plain_text.h"
#include "core/photometry/colour_index.h"

namespace blackhole {

namespace {

enum Column { kRa, kDec, kVmag, kBv, kTemperature, kParallax, kHip, kName, kColumns };

struct ColumnRule {
	std::string_view name;
	double least;
	double most;
	bool required;
	std::string_view range; ///< as the user reads it
};

constexpr std::array<ColumnRule, kColumns> kRules = {{
		{"ra_deg", -360.0, 360.0, true, "-360 to 360 degrees"},
		{"dec_deg", -90.0, 90.0, true, "-90 to 90 degrees"},
		{"vmag", kMagnitudes.least, kMagnitudes.most, true, "-100 to 100 magnitudes"},
		{"bv", kColourIndices.least, kColourIndices.most, false, "-5 to 20 magnitudes, or empty"},
		{"temperature_k", kTemperatures.least, kTemperatures.most, false, "100 to 1e9 kelvin, or empty"},
		{"parallax_mas", kParallaxes.least, kParallaxes.most, false, "-1e6 to 1e6 milliarcseconds, or empty"},
		{"hip", 0.0, 4294967295.0, false, "a whole number from 0 to 4294967295, or empty"},
		{"name", 0.0, 0.0, false, "text"},
}};

constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);
using Places = std::array<std::size_t, kColumns>;

std::string lower(std::string p_text) {
	for (char &c : p_text) {
		c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
	}
	return p_text;
}

/// Where each column is; otherwise what is wrong with the header and what to do.
Outcome<Places> find_columns(const std::vector<std::string> &p_header) {
	Places places;
	places.fill(kAbsent);
	for (std::size_t field = 0; field < p_header.size(); ++field) {
		const std::string name = lower(p_header[field]);
		for (std::size_t column = 0; column < kColumns; ++column) {
			if (name != kRules[column].name) {
				continue;
			}
			if (places[column] != kAbsent) {
				return Outcome<Places>::failure("the column '" + name + "' comes twice: remove one of them");
			}
			places[column] = field;
		}
	}
	for (std::size_t column = 0; column < kColumns; ++column) {
		if (kRules[column].required && places[column] == kAbsent) {
			return Outcome<Places>::failure("the column '" + std::string(kRules[column].name) +
					"' is missing: the first line must name the columns ra_deg,dec_deg,vmag (and, if you "
					"have "
					"them, bv, temperature_k, parallax_mas, hip, name)");
		}
	}
	return Outcome<Places>::success(places);
}

std::optional<double> parse(std::string_view p_text) {
	if (p_text.starts_with('+')) {
		p_text.remove_prefix(1);
	}
	double value = 0.0;
	const auto [end, fault] = std::from_chars(p_text.data(), p_text.data() + p_text.size(), value);
	if (fault != std::errc() || end != p_text.data() + p_text.size() || !std::isfinite(value)) {
		return std::nullopt;
	}
	return value;
}

/// Turns the records of one file into stars.
class RowReader {
public:
	explicit RowReader(const Places &p_places) : m_places(p_places) {}

	/// Adds the star of one record to r_table. Returns what is wrong, empty when nothing is.
	std::string read(const std::vector<std::string> &p_fields, StarTable &r_table) const {
		std::array<std::optional<double>, kColumns> values;
		for (std::size_t column = 0; column < kName; ++column) {
			const std::string_view text = field(p_fields, column);
			if (text.empty() && !kRules[column].required) {
				continue;
			}
			values[column] = parse(text);
			if (!accepts(column, values[column])) {
				return "the value '" + shown_in_message(text) + "' of column '" +
						std::string(kRules[column].name) + "' is not usable: give " +
						std::string(kRules[column].range) + ", or remove the row";
			}
		}
		Star star;
		const double turns = *values[kRa] / 360.0;
		star.right_ascension = 2.0 * std::numbers::pi * (turns - std::floor(turns));
		star.declination = *values[kDec] * std::numbers::pi / 180.0;
		star.v_magnitude = static_cast<float>(*values[kVmag]);
		star.b_minus_v = number(values[kBv], kUnknown);
		star.parallax_mas = number(values[kParallax], kUnknown);
		star.hip = static_cast<std::uint32_t>(values[kHip].value_or(0.0));
		const float of_colour = values[kBv] ? static_cast<float>(m_colour_temperature(*values[kBv]))
											: kTemperatureWithoutColour;
		star.temperature_k = number(values[kTemperature], of_colour);
		if (const std::string_view name = field(p_fields, kName); !name.empty()) {
			if (!is_plain_text(name)) {
				return "the name '" + shown_in_message(name) +
						"' is not UTF-8: save the file in that encoding";
			}
			star.name = static_cast<std::uint32_t>(r_table.names.size());
			r_table.names.emplace_back(name);
		}
		r_table.stars.push_back(star);
		return {};
	}

private:
	std::string_view field(const std::vector<std::string> &p_fields, std::size_t p_column) const {
		const std::size_t place = m_places[p_column];
		return place < p_fields.size() ? std::string_view(p_fields[place]) : std::string_view();
	}

	static bool accepts(std::size_t p_column, std::optional<double> p_value) {
		return p_value && *p_value >= kRules[p_column].least && *p_value <= kRules[p_column].most &&
				(p_column != kHip || *p_value == std::floor(*p_value));
	}

	static float number(std::optional<double> p_value, float p_otherwise) {
		return p_value ? static_cast<float>(*p_value) : p_otherwise;
	}

	Places m_places;
	ColourTemperature m_colour_temperature;
};

Outcome<StarTable> refuse(std::string_view p_name, std::size_t p_line, const std::string &p_why) {
	return Outcome<StarTable>::failure(
			std::string(p_name) + ", line " + std::to_string(p_line) + ": " + p_why);
}

} // namespace

std::string star_csv_fault(std::string_view p_head, std::string_view p_name) {
	CsvRecords records(p_head.substr(0, kStarCsvHead));
	const bool found = records.next();
	if (records.is_at_end()) { // the header line may go on
		return {};
	}
	if (!found) {
		return refuse(p_name, records.line(), records.fault()).error;
	}
	const Outcome<Places> places = find_columns(records.fields());
	return places ? std::string() : refuse(p_name, records.line(), places.error).error;
}

Outcome<StarTable> read_star_csv(std::string_view p_text, std::string_view p_name) {
	CsvRecords records(p_text);
	if (!records.next()) {
		const std::string why = records.fault().empty()
				? "the file is empty: give a header line (ra_deg,dec_deg,vmag) and one row for each star"
				: records.fault();
		return refuse(p_name, std::max<std::size_t>(records.line(), 1), why);
	}
	const std::size_t header_line = records.line();
	const Outcome<Places> places = find_columns(records.fields());
	if (!places) {
		return refuse(p_name, header_line, places.error);
	}
	const RowReader reader(*places.value);
	StarTable table;
	while (records.next()) {
		if (table.stars.size() == kMostStars) {
			return refuse(p_name, records.line(),
					"more than " + std::to_string(kMostStars) + " stars: keep the brightest ones only");
		}
		if (const std::string wrong = reader.read(records.fields(), table); !wrong.empty()) {
			return refuse(p_name, records.line(), wrong);
		}
	}
	if (!records.fault().empty()) {
		return refuse(p_name, records.line(), records.fault());
	}
	if (table.stars.empty()) {
		return refuse(p_name, header_line, "no star follows the header: add one row for each star");
	}
	table.sort_by_magnitude();
	return Outcome<StarTable>::success(std::move(table));
}

} // namespace blackhole
