// SPDX-License-Identifier: MIT
#include "core/catalogue/star_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <utility>

#include <zlib.h>

#include "core/catalogue/plain_text.h"

namespace blackhole {

namespace {

constexpr std::array<std::uint8_t, 8> kMagic = {'B', 'H', 'S', 'T', 'A', 'R', 'S', 0};
constexpr std::uint32_t kVersion = 1;
constexpr double kEpoch = 2000.0;
constexpr std::size_t kChecksumAt = 32;
constexpr std::uint64_t kStarSize = 28;
constexpr double kRadiansPerUnit = 2.0 * std::numbers::pi / 4294967296.0;
constexpr std::int64_t kQuarterTurn = 1 << 30;

template <class T>
T load(const std::uint8_t *p_from) {
	std::array<std::uint8_t, sizeof(T)> bytes{};
	std::memcpy(bytes.data(), p_from, sizeof(T));
	if constexpr (std::endian::native == std::endian::big) {
		std::reverse(bytes.begin(), bytes.end());
	}
	return std::bit_cast<T>(bytes);
}

template <class T>
void store(std::uint8_t *p_to, T p_value) {
	auto bytes = std::bit_cast<std::array<std::uint8_t, sizeof(T)>>(p_value);
	if constexpr (std::endian::native == std::endian::big) {
		std::reverse(bytes.begin(), bytes.end());
	}
	std::memcpy(p_to, bytes.data(), sizeof(T));
}

/// CRC-32 (zlib's) of the file without the checksum itself.
std::uint32_t checksum(std::span<const std::uint8_t> p_bytes) {
	const auto head = crc32_z(0, p_bytes.data(), kChecksumAt);
	const auto body = p_bytes.subspan(kStarFileHeaderSize);
	return static_cast<std::uint32_t>(crc32_z(head, body.data(), body.size()));
}

Outcome<StarTable> refuse(std::string_view p_name, const std::string &p_why) {
	return Outcome<StarTable>::failure(std::string(p_name) + ": " + p_why);
}

struct Header {
	std::uint32_t stars;
	std::uint32_t names;
	std::uint32_t text;
};

Header header_of(std::span<const std::uint8_t> p_head) {
	return {load<std::uint32_t>(p_head.data() + 12), load<std::uint32_t>(p_head.data() + 16),
			load<std::uint32_t>(p_head.data() + 20)};
}

/// Empty when the header fits a file of this size, otherwise what is wrong and what to do.
std::string check_size(const Header &p_header, std::uint64_t p_size) {
	const std::uint64_t expected = kStarFileHeaderSize + kStarSize * p_header.stars + 4ULL * p_header.names +
			std::uint64_t{p_header.text};
	if (p_size != expected) {
		return "has " + std::to_string(p_size) + " bytes where its header announces " +
				std::to_string(expected) + "; it is truncated or damaged: copy it again or rebuild it with " +
				"tools/catalogue/build_hipparcos.py";
	}
	if (p_header.stars == 0) {
		return "holds no star: choose another catalogue";
	}
	if (p_header.stars > kMostStars) {
		return "holds more than " + std::to_string(kMostStars) + " stars: keep the brightest ones only";
	}
	return {};
}

bool plausible(const Star &p_star) {
	const auto known = [](float p_value, const Range &p_range) {
		return std::isnan(p_value) || p_range.holds(p_value);
	};
	return kMagnitudes.holds(p_star.v_magnitude) && kTemperatures.holds(p_star.temperature_k) &&
			known(p_star.b_minus_v, kColourIndices) && known(p_star.parallax_mas, kParallaxes);
}

/// Reads the columns; false when a value is out of range.
bool read_stars(const std::uint8_t *p_columns, std::vector<Star> &r_stars) {
	const std::size_t step = 4 * r_stars.size();
	bool good = true;
	for (std::size_t i = 0; i < r_stars.size(); ++i) {
		const std::uint8_t *at = p_columns + 4 * i;
		Star &star = r_stars[i];
		const auto declination = load<std::int32_t>(at + step);
		star.right_ascension = kRadiansPerUnit * load<std::uint32_t>(at);
		star.declination = kRadiansPerUnit * declination;
		star.v_magnitude = load<float>(at + 2 * step);
		star.b_minus_v = load<float>(at + 3 * step);
		star.temperature_k = load<float>(at + 4 * step);
		star.parallax_mas = load<float>(at + 5 * step);
		star.hip = load<std::uint32_t>(at + 6 * step);
		good = good && std::abs(std::int64_t{declination}) <= kQuarterTurn && plausible(star);
	}
	return good;
}

/// Reads the names, p_header.names star numbers followed by as many zero-ended texts; false when they do not
/// fit.
bool read_names(const std::uint8_t *p_from, const Header &p_header, StarTable &r_table) {
	const std::uint8_t *text = p_from + 4ULL * p_header.names;
	const std::uint8_t *const end = text + p_header.text;
	for (std::uint32_t i = 0; i < p_header.names; ++i) {
		const auto star = load<std::uint32_t>(p_from + 4ULL * i);
		const std::uint8_t *const stop = std::find(text, end, std::uint8_t{0});
		if (star >= p_header.stars || stop == end) {
			return false;
		}
		r_table.stars[star].name = static_cast<std::uint32_t>(r_table.names.size());
		if (!is_plain_text(r_table.names.emplace_back(text, stop))) {
			return false;
		}
		text = stop + 1;
	}
	return text == end;
}

} // namespace

bool is_star_file(std::span<const std::uint8_t> p_bytes) {
	return p_bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), p_bytes.begin());
}

std::string star_file_fault(
		std::span<const std::uint8_t> p_head, std::uint64_t p_size, std::string_view p_name) {
	if (p_head.size() < kStarFileHeaderSize || !std::equal(kMagic.begin(), kMagic.end(), p_head.begin())) {
		return refuse(
				p_name, "is not a .stars catalogue: give a file made by tools/catalogue, or a .csv table")
				.error;
	}
	if (const auto version = load<std::uint32_t>(p_head.data() + 8); version != kVersion) {
		return refuse(p_name,
				"is of version " + std::to_string(version) + ", this program reads version " +
						std::to_string(kVersion) + ": rebuild it with tools/catalogue/build_hipparcos.py")
				.error;
	}
	const std::string wrong = check_size(header_of(p_head), p_size);
	return wrong.empty() ? wrong : refuse(p_name, wrong).error;
}

Outcome<StarTable> read_star_file(std::span<const std::uint8_t> p_bytes, std::string_view p_name) {
	if (std::string fault = star_file_fault(p_bytes, p_bytes.size(), p_name); !fault.empty()) {
		return Outcome<StarTable>::failure(std::move(fault));
	}
	if (load<std::uint32_t>(p_bytes.data() + kChecksumAt) != checksum(p_bytes)) {
		return refuse(p_name,
				"its checksum is wrong, so the file is damaged: copy it again or rebuild it with "
				"tools/catalogue/build_hipparcos.py");
	}
	if (load<double>(p_bytes.data() + 24) != kEpoch) {
		return refuse(p_name, "is not for epoch J2000.0: build it again with positions of that epoch");
	}
	const Header header = header_of(p_bytes);
	StarTable table;
	table.stars.resize(header.stars);
	const std::uint8_t *const columns = p_bytes.data() + kStarFileHeaderSize;
	if (!read_stars(columns, table.stars) || !read_names(columns + kStarSize * header.stars, header, table)) {
		return refuse(p_name, "has values out of range: rebuild it with tools/catalogue/build_hipparcos.py");
	}
	table.sort_by_magnitude();
	return Outcome<StarTable>::success(std::move(table));
}

std::vector<std::uint8_t> write_star_file(const StarTable &p_table) {
	StarTable sorted = p_table;
	sorted.sort_by_magnitude();
	const auto &stars = sorted.stars;
	std::vector<std::uint32_t> named;
	std::string text;
	for (std::size_t i = 0; i < stars.size(); ++i) {
		if (const std::string &name = sorted.name_of(stars[i]); !name.empty()) {
			named.push_back(static_cast<std::uint32_t>(i));
			text += name + '\0';
		}
	}
	std::vector<std::uint8_t> bytes(
			kStarFileHeaderSize + kStarSize * stars.size() + 4 * named.size() + text.size());
	std::copy(kMagic.begin(), kMagic.end(), bytes.begin());
	store(bytes.data() + 8, kVersion);
	store(bytes.data() + 12, static_cast<std::uint32_t>(stars.size()));
	store(bytes.data() + 16, static_cast<std::uint32_t>(named.size()));
	store(bytes.data() + 20, static_cast<std::uint32_t>(text.size()));
	store(bytes.data() + 24, kEpoch);
	std::uint8_t *at = bytes.data() + kStarFileHeaderSize;
	const auto column = [&](const auto &p_from, auto p_value_of) {
		for (const auto &each : p_from) {
			store(at, p_value_of(each));
			at += 4;
		}
	};
	column(stars, [](const Star &p_star) {
		return static_cast<std::uint32_t>(std::llround(p_star.right_ascension / kRadiansPerUnit));
	});
	column(stars, [](const Star &p_star) {
		return static_cast<std::int32_t>(std::lround(p_star.declination / kRadiansPerUnit));
	});
	column(stars, [](const Star &p_star) { return p_star.v_magnitude; });
	column(stars, [](const Star &p_star) { return p_star.b_minus_v; });
	column(stars, [](const Star &p_star) { return p_star.temperature_k; });
	column(stars, [](const Star &p_star) { return p_star.parallax_mas; });
	column(stars, [](const Star &p_star) { return p_star.hip; });
	column(named, [](std::uint32_t p_index) { return p_index; });
	std::copy(text.begin(), text.end(), at);
	store(bytes.data() + kChecksumAt, checksum(bytes));
	return bytes;
}

} // namespace blackhole
