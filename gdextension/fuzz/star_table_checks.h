// SPDX-License-Identifier: MIT
#pragma once

#include "core/catalogue/star.h"

namespace blackhole::fuzz {

/// What holds of every catalogue that a reader accepts: it has stars, brightest first, all of their values
/// are in the documented ranges, names are those of the table.
void demand_sound(const StarTable &p_table);

/// The two hold the same stars; angles within p_tolerance radians.
void demand_same(const StarTable &p_first, const StarTable &p_second, double p_tolerance);

/// The table, written as a .stars file, is read back the same, and that again to the byte.
void demand_round_trip(const StarTable &p_table);

} // namespace blackhole::fuzz
