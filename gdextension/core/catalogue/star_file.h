// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/catalogue/star.h"
#include "core/outcome.h"

namespace blackhole {

/// Whether bytes begin as those of a .stars file do.
bool is_star_file(std::span<const std::uint8_t> p_bytes);

/// Reads the .stars format (see README.md in this folder) from memory. p_name is the file's name for
/// messages. Fails on a wrong magic, version, size or checksum and on values out of range (star.h); nothing
/// is allocated from a count that the size of p_bytes does not bear out.
Outcome<StarTable> read_star_file(std::span<const std::uint8_t> p_bytes, std::string_view p_name);

inline constexpr std::size_t kStarFileHeaderSize = 36;

/// What is wrong with a file of p_size bytes that starts with p_head (kStarFileHeaderSize bytes, or all there
/// are), as far as these tell: with it a file is refused before it is read. Empty when nothing is.
std::string star_file_fault(
		std::span<const std::uint8_t> p_head, std::uint64_t p_size, std::string_view p_name);

/// The bytes of a .stars file with the stars of p_table, brightest first. Angles are rounded to 2^-32 of a
/// turn (0.3 milliarcseconds).
std::vector<std::uint8_t> write_star_file(const StarTable &p_table);

} // namespace blackhole
