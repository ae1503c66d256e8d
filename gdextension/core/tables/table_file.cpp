// SPDX-License-Identifier: MIT
#include "core/tables/table_file.h"

#include "core/tables/ray_axis.h"
#include "core/tables/table_axis.h"

#include <zlib.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace blackhole {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic = {'B', 'H', 'L', 'E', 'N', 'S', '\r', '\n'};

/// Where the header's fields lie; all numbers are little-endian.
enum Field : std::size_t {
	kVersionAt = 8,
	kHeaderSizeAt = 12,
	kColumnsAt = 16,
	kRowsAt = 20,
	kTableCountAt = 24,
	kChannelsAt = 28,
	kLnUMinAt = 32,
	kLnUMaxAt = 40,
	kXLimitAt = 48,
	kRayColumnsAt = 56,
	kRayRowsAt = 60,
	kDataCrcAt = 64,
	kHeaderCrcAt = 68,
};

constexpr std::uint32_t kTableCount = 4;
constexpr std::uint32_t kChannels = 4;

/// The tables in the file's order.
template <class Tables>
auto parts_of(Tables &tables) {
	return std::array{&tables.inverse, &tables.forward, &tables.rays.radius, &tables.rays.delay};
}

template <class Number>
void put(std::vector<std::uint8_t> &bytes, std::size_t at, Number number) {
	for (std::size_t i = 0; i < sizeof(Number); ++i) {
		bytes[at + i] = static_cast<std::uint8_t>(number >> (8 * i));
	}
}

template <class Number>
Number get(std::span<const std::uint8_t> bytes, std::size_t at) {
	Number number = 0;
	for (std::size_t i = 0; i < sizeof(Number); ++i) {
		number |= static_cast<Number>(bytes[at + i]) << (8 * i);
	}
	return number;
}

double get_double(std::span<const std::uint8_t> bytes, std::size_t at) {
	return std::bit_cast<double>(get<std::uint64_t>(bytes, at));
}

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
	return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

bool is_side(std::uint32_t size) {
	return size >= 2 && size <= kTableFileMaxSide;
}

/// What is wrong with the header of a file of this size; empty if it is in order.
std::string header_fault(std::span<const std::uint8_t> bytes, std::uint64_t size) {
	if (bytes.size() < kMagic.size() || std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0) {
		return "it is no lensing table (the file does not start with BHLENS)";
	}
	if (bytes.size() < kTableFileHeaderSize) {
		return "it is cut off inside the header";
	}
	const auto version = get<std::uint32_t>(bytes, kVersionAt);
	if (version != kTableFileVersion) {
		return "it has format version " + std::to_string(version) + ", this program reads version " +
				std::to_string(kTableFileVersion);
	}
	if (get<std::uint32_t>(bytes, kHeaderCrcAt) != checksum(bytes.first(kHeaderCrcAt))) {
		return "its header is damaged (checksum)";
	}
	const auto columns = get<std::uint32_t>(bytes, kColumnsAt);
	const auto rows = get<std::uint32_t>(bytes, kRowsAt);
	const auto ray_columns = get<std::uint32_t>(bytes, kRayColumnsAt);
	const auto ray_rows = get<std::uint32_t>(bytes, kRayRowsAt);
	if (get<std::uint32_t>(bytes, kHeaderSizeAt) != kTableFileHeaderSize ||
			get<std::uint32_t>(bytes, kTableCountAt) != kTableCount ||
			get<std::uint32_t>(bytes, kChannelsAt) != kChannels || !is_side(columns) || !is_side(rows) ||
			!is_side(ray_columns) || !is_side(ray_rows)) {
		return "its header asks for impossible sizes";
	}
	// At most 4096 x 4096 x 4 x 16 bytes: no overflow in 64 bits.
	const std::uint64_t texels = std::uint64_t{columns} * rows + std::uint64_t{ray_columns} * ray_rows;
	const std::uint64_t expected = kTableFileHeaderSize + 2 * texels * kChannels * sizeof(float);
	if (size != expected) {
		return "it has " + std::to_string(size) + " bytes instead of " + std::to_string(expected);
	}
	if (columns != kTableColumns || rows != kTableRows || ray_columns != kRayColumns ||
			ray_rows != kRayRows || std::abs(get_double(bytes, kLnUMinAt) - std::log(kTableUMin)) > 1e-12 ||
			std::abs(get_double(bytes, kLnUMaxAt) - std::log(kTableUMax)) > 1e-12 ||
			get_double(bytes, kXLimitAt) != kTableXLimit) {
		return "its grid is not the one the shaders are written for";
	}
	return {};
}

std::string refusal(const std::string &name, const std::string &fault) {
	return "Lensing table " + name + " cannot be used: " + fault + ". Re-make it with ./run bake.";
}

/// Decodes floats; false if one is not finite.
bool get_floats(std::span<const std::uint8_t> bytes, std::size_t at, std::vector<float> &numbers) {
	bool finite = true;
	for (float &number : numbers) {
		number = std::bit_cast<float>(get<std::uint32_t>(bytes, at));
		finite = finite && std::isfinite(number);
		at += sizeof(float);
	}
	return finite;
}

} // namespace

std::vector<std::uint8_t> write_lensing_tables(const LensingTables &tables) {
	std::size_t floats = 0;
	for (const std::vector<float> *table : parts_of(tables)) {
		floats += table->size();
	}
	std::vector<std::uint8_t> bytes(kTableFileHeaderSize + floats * sizeof(float));
	std::memcpy(bytes.data(), kMagic.data(), kMagic.size());
	put(bytes, kVersionAt, kTableFileVersion);
	put(bytes, kHeaderSizeAt, static_cast<std::uint32_t>(kTableFileHeaderSize));
	put(bytes, kColumnsAt, static_cast<std::uint32_t>(tables.columns));
	put(bytes, kRowsAt, static_cast<std::uint32_t>(tables.rows));
	put(bytes, kTableCountAt, kTableCount);
	put(bytes, kChannelsAt, kChannels);
	put(bytes, kLnUMinAt, std::bit_cast<std::uint64_t>(tables.ln_u_min));
	put(bytes, kLnUMaxAt, std::bit_cast<std::uint64_t>(tables.ln_u_max));
	put(bytes, kXLimitAt, std::bit_cast<std::uint64_t>(tables.x_limit));
	put(bytes, kRayColumnsAt, static_cast<std::uint32_t>(kRayColumns));
	put(bytes, kRayRowsAt, static_cast<std::uint32_t>(kRayRows));
	std::size_t at = kTableFileHeaderSize;
	for (const std::vector<float> *table : parts_of(tables)) {
		for (const float number : *table) {
			put(bytes, at, std::bit_cast<std::uint32_t>(number));
			at += sizeof(float);
		}
	}
	const std::span<const std::uint8_t> view(bytes);
	put(bytes, kDataCrcAt, checksum(view.subspan(kTableFileHeaderSize)));
	put(bytes, kHeaderCrcAt, checksum(view.first(kHeaderCrcAt)));
	return bytes;
}

std::string table_file_fault(
		std::span<const std::uint8_t> head, std::uint64_t size, const std::string &name) {
	const std::string fault = header_fault(head, size);
	return fault.empty() ? fault : refusal(name, fault);
}

Outcome<LensingTables> parse_lensing_tables(std::span<const std::uint8_t> bytes, const std::string &name) {
	std::string fault = header_fault(bytes, bytes.size());
	if (fault.empty() &&
			get<std::uint32_t>(bytes, kDataCrcAt) != checksum(bytes.subspan(kTableFileHeaderSize))) {
		fault = "its table values are damaged (checksum)";
	}
	LensingTables tables;
	if (fault.empty()) {
		tables.columns = static_cast<int>(get<std::uint32_t>(bytes, kColumnsAt));
		tables.rows = static_cast<int>(get<std::uint32_t>(bytes, kRowsAt));
		tables.ln_u_min = get_double(bytes, kLnUMinAt);
		tables.ln_u_max = get_double(bytes, kLnUMaxAt);
		tables.x_limit = get_double(bytes, kXLimitAt);
		const std::size_t floats = static_cast<std::size_t>(tables.columns) * tables.rows * kChannels;
		tables.inverse.resize(floats);
		tables.forward.resize(floats);
		constexpr std::size_t kRayFloats = std::size_t{kRayColumns} * kRayRows * kChannels;
		tables.rays.radius.resize(kRayFloats);
		tables.rays.delay.resize(kRayFloats);
		std::size_t at = kTableFileHeaderSize;
		for (std::vector<float> *table : parts_of(tables)) {
			if (!get_floats(bytes, at, *table)) {
				fault = "it holds values that are no numbers";
			}
			at += table->size() * sizeof(float);
		}
	}
	if (!fault.empty()) {
		return Outcome<LensingTables>::failure(refusal(name, fault));
	}
	return Outcome<LensingTables>::success(std::move(tables));
}

Outcome<LensingTables> read_lensing_tables(std::span<const std::uint8_t> bytes, const std::string &name) {
	Outcome<LensingTables> tables = parse_lensing_tables(bytes, name);
	if (tables) {
		tables.value->ray_texels = sample_ray_tables(tables.value->rays);
	}
	return tables;
}

} // namespace blackhole
