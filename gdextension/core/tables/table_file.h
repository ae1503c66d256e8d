// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"
#include "core/tables/lensing_tables.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace blackhole {

/// The .lut file: a header of 72 bytes, then the tables. lut/README.md describes every byte.
inline constexpr std::uint32_t kTableFileVersion = 2;
inline constexpr std::size_t kTableFileHeaderSize = 72;
/// No table file may ask for more columns or rows than this (a 2-D texture's safe size).
inline constexpr std::uint32_t kTableFileMaxSide = 4096;

/// The bytes of the file for these tables.
std::vector<std::uint8_t> write_lensing_tables(const LensingTables &tables);

/// What is wrong with a file of `size` bytes that starts with `head` (kTableFileHeaderSize bytes, or all
/// there are), as far as these tell: with it a file is refused before it is read. Empty when nothing is.
std::string table_file_fault(std::span<const std::uint8_t> head, std::uint64_t size, const std::string &name);

/// The tables in these bytes, as they are in the file: without ray_texels, which take most of the time.
/// `name` names the file in messages. Nothing is allocated before the sizes are known to agree with the bytes
/// at hand; every damage gives a reason and the remedy.
Outcome<LensingTables> parse_lensing_tables(std::span<const std::uint8_t> bytes, const std::string &name);

/// The same, complete.
Outcome<LensingTables> read_lensing_tables(std::span<const std::uint8_t> bytes, const std::string &name);

} // namespace blackhole
