// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/catalogue/star.h"
#include "core/outcome.h"

namespace blackhole {

/// Reads a star table from comma-separated text with a header line, in any order of columns:
///   ra_deg, dec_deg   ICRS J2000 in degrees, -360..360 and -90..90    required
///   vmag              Johnson V, -100..100                             required
///   bv                Johnson B-V, -5..20
///   temperature_k     of the black body the star is drawn as, 100..1e9
///   parallax_mas      milliarcseconds, -1e6..1e6
///   hip               Hipparcos number, a whole number up to 2^32 - 1
///   name              UTF-8
/// Further columns are ignored; an empty field of an optional column means unknown. Without temperature_k the
/// temperature follows from bv (ColourTemperature), without both it is kTemperatureWithoutColour. Refuses a
/// missing or doubled column, a value that is not finite or out of range, a name that is not UTF-8, a line
/// over 65536 bytes, more than kMostStars rows and a table without rows; the message names p_name, the line
/// and the remedy.
Outcome<StarTable> read_star_csv(std::string_view p_text, std::string_view p_name);

/// How much of a file's start star_csv_fault looks at, bytes.
inline constexpr std::size_t kStarCsvHead = 131072;

/// What is wrong with a table whose text starts with p_head, as far as its header line tells: with it a file
/// is refused before all of it is read. Empty when nothing is, or when p_head ends before the header line.
std::string star_csv_fault(std::string_view p_head, std::string_view p_name);

} // namespace blackhole
