// SPDX-License-Identifier: MIT
#include "core/catalogue/plain_text.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace blackhole {

namespace {

constexpr std::size_t kShown = 40;

/// One length of UTF-8 sequences: which first bytes announce it and what code points it is for.
struct Sequence {
	unsigned first_mask;
	unsigned first;
	std::size_t following;
	std::uint32_t least;
};

constexpr std::array<Sequence, 4> kSequences = {{
		{0x80, 0x00, 0, 0x1},
		{0xE0, 0xC0, 1, 0x80},
		{0xF0, 0xE0, 2, 0x800},
		{0xF8, 0xF0, 3, 0x10000},
}};

/// How many bytes the code point at the start of p_text has; 0 when there is none that Unicode knows.
std::size_t code_point_size(std::string_view p_text) {
	const auto byte_at = [p_text](std::size_t p_index) -> unsigned {
		return static_cast<std::uint8_t>(p_text[p_index]);
	};
	for (const Sequence &sequence : kSequences) {
		if ((byte_at(0) & sequence.first_mask) != sequence.first || sequence.following >= p_text.size()) {
			continue;
		}
		std::uint32_t point = byte_at(0) & ~sequence.first_mask;
		for (std::size_t i = 1; i <= sequence.following; ++i) {
			if ((byte_at(i) & 0xC0U) != 0x80U) {
				return 0;
			}
			point = point << 6U | (byte_at(i) & 0x3FU);
		}
		const bool surrogate = point >= 0xD800 && point <= 0xDFFF;
		return point >= sequence.least && point <= 0x10FFFF && !surrogate ? sequence.following + 1 : 0;
	}
	return 0;
}

} // namespace

bool is_plain_text(std::string_view p_text) {
	while (!p_text.empty()) {
		const std::size_t size = code_point_size(p_text);
		if (size == 0) {
			return false;
		}
		p_text.remove_prefix(size);
	}
	return true;
}

std::string shown_in_message(std::string_view p_text) {
	std::string shown;
	for (const char c : p_text.substr(0, kShown)) {
		shown.push_back(c >= ' ' && c <= '~' ? c : '?');
	}
	return p_text.size() > kShown ? shown + "..." : shown;
}

} // namespace blackhole
