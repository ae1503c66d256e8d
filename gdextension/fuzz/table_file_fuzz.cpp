// SPDX-License-Identifier: MIT
// The reader of lensing tables. A whole one has 786504 bytes, which mutation would hardly get through: the
// first byte of the input says what the others are (README.md).
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <zlib.h>

#include "core/tables/table_file.h"
#include "fuzz/demand.h"
#include "lut_cli/ray_source.h"

namespace {

using namespace blackhole;
using Bytes = std::vector<std::uint8_t>;

enum Input : std::uint8_t { kWholeFile, kHeader, kPatches, kInputs };
/// With this first byte, which means patches, what is accepted is looked up too. That takes long.
constexpr std::uint8_t kLookUp = 128;
static_assert(kLookUp % kInputs == kPatches);

constexpr std::size_t kDataChecksumAt = 64;
constexpr std::size_t kHeaderChecksumAt = 68;

const Bytes &committed_table() {
	static const Bytes bytes = [] {
		std::ifstream file(BLACKHOLE_COMMITTED_TABLE, std::ios::binary);
		return Bytes(std::istreambuf_iterator<char>(file), {});
	}();
	fuzz::demand(bool{parse_lensing_tables(bytes, "committed.lut")}, "the committed table is good");
	return bytes;
}

void put(Bytes &r_bytes, std::size_t p_at, std::uint32_t p_number) {
	for (std::size_t i = 0; i < sizeof p_number; ++i, p_number >>= 8U) {
		r_bytes[p_at + i] = static_cast<std::uint8_t>(p_number);
	}
}

void seal(Bytes &r_bytes) {
	const auto body = std::span(r_bytes).subspan(kTableFileHeaderSize);
	put(r_bytes, kDataChecksumAt, static_cast<std::uint32_t>(crc32_z(0, body.data(), body.size())));
	put(r_bytes, kHeaderChecksumAt,
			static_cast<std::uint32_t>(crc32_z(0, r_bytes.data(), kHeaderChecksumAt)));
}

std::uint32_t number_at(std::span<const std::uint8_t> p_input, std::size_t p_at) {
	std::uint32_t number = 0;
	std::memcpy(&number, p_input.data() + p_at, sizeof number);
	return number;
}

/// The file that an input stands for.
Bytes file_of(std::span<const std::uint8_t> p_input) {
	const auto kind = static_cast<Input>(p_input[0] % kInputs);
	const auto rest = p_input.subspan(1);
	if (kind == kWholeFile) {
		return {rest.begin(), rest.end()};
	}
	Bytes bytes = committed_table();
	if (kind == kHeader) {
		std::copy_n(rest.begin(), std::min(rest.size(), kTableFileHeaderSize), bytes.begin());
	} else {
		for (std::size_t i = 0; i + 8 <= rest.size(); i += 8) {
			const std::size_t texel = number_at(rest, i) % ((bytes.size() - kTableFileHeaderSize) / 4);
			put(bytes, kTableFileHeaderSize + 4 * texel, number_at(rest, i + 4));
		}
	}
	seal(bytes);
	return bytes;
}

/// Whatever the numbers in the tables are, reading them ends.
void look_up(const LensingTables &p_tables) {
	const TabulatedRays rays(p_tables);
	for (const double u : {1e-8, 0.3, 0.9, 4.0}) {
		static_cast<void>(rays.angle(u, rays.image(u, 2.0).y));
		static_cast<void>(rays.disk({u, 1.2, 0.4, 0.7, ObserverMotion::kRain}, 1));
	}
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *p_data, std::size_t p_size) {
	if (p_size == 0) {
		return 0;
	}
	const Bytes bytes = file_of({p_data, p_size});
	auto tables = parse_lensing_tables(bytes, "some.lut");
	const std::size_t head = std::min(bytes.size(), kTableFileHeaderSize);
	const std::string fault = table_file_fault(std::span(bytes).first(head), bytes.size(), "some.lut");
	if (!tables) {
		fuzz::demand_reason(tables.error, "some.lut");
		fuzz::demand(fault.empty() || fault == tables.error, "the start tells the same");
		return 0;
	}
	fuzz::demand(fault.empty(), "the start of a good file is good");
	fuzz::demand(write_lensing_tables(*tables.value) == bytes, "what was read is written the same");
	if (p_data[0] == kLookUp) {
		tables.value->ray_texels = sample_ray_tables(tables.value->rays);
		look_up(*tables.value);
	}
	return 0;
}
