// SPDX-License-Identifier: MIT
// The .stars reader: takes the bytes as they are, and again with the checksum made right, without which
// hardly any change would come past it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <zlib.h>

#include "core/catalogue/star_file.h"
#include "fuzz/demand.h"
#include "fuzz/star_table_checks.h"

namespace {

using namespace blackhole;

constexpr std::size_t kChecksumAt = 32;

void seal(std::vector<std::uint8_t> &r_bytes) {
	const auto head = crc32_z(0, r_bytes.data(), kChecksumAt);
	const std::span<const std::uint8_t> body = std::span(r_bytes).subspan(kStarFileHeaderSize);
	auto crc = static_cast<std::uint32_t>(crc32_z(head, body.data(), body.size()));
	for (std::size_t i = 0; i < sizeof crc; ++i, crc >>= 8U) {
		r_bytes[kChecksumAt + i] = static_cast<std::uint8_t>(crc);
	}
}

void read(const std::vector<std::uint8_t> &p_bytes) {
	const auto table = read_star_file(p_bytes, "sky.stars");
	const std::size_t head = std::min(p_bytes.size(), kStarFileHeaderSize);
	const std::string fault = star_file_fault(std::span(p_bytes).first(head), p_bytes.size(), "sky.stars");
	if (!table) {
		fuzz::demand_reason(table.error, "sky.stars");
		fuzz::demand(fault.empty() || fault == table.error, "the start tells the same");
		return;
	}
	fuzz::demand(fault.empty(), "the start of a good file is good");
	fuzz::demand_sound(*table.value);
	fuzz::demand_round_trip(*table.value);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *p_data, std::size_t p_size) {
	std::vector<std::uint8_t> bytes(p_data, p_data + p_size);
	read(bytes);
	if (bytes.size() >= kStarFileHeaderSize) {
		seal(bytes);
		read(bytes);
	}
	return 0;
}
