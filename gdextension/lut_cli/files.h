// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"
#include "core/tables/lensing_tables.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace blackhole {

/// The whole content of the file at `path`, if it has at most `limit` bytes.
Outcome<std::string> read_file(const std::string &path, std::size_t limit);

/// Writes the file whole or not at all. Returns an error message, empty on success.
std::string write_file(const std::string &path, std::string_view content);

/// The lensing tables in the .lut file at `path`.
Outcome<LensingTables> load_table_file(const std::string &path);

} // namespace blackhole
