// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace blackhole {

/// The subcommands of blackhole-lut round the table file. Each returns an error message, empty on success.

/// `bake`: computes both tables with a progress bar on the standard error stream and writes them to out_path
/// (if not empty); with check_path also compares them with that file and fails where they differ by more than
/// the last digits in which two mathematical libraries may differ.
std::string run_bake(const std::string &out_path, const std::string &check_path);

/// `inspect`: prints the header and what the tables hold.
std::string run_inspect(const std::string &path);

/// `verify`: prints the largest and the 99.9 % errors of the tables in `path` (freshly baked if empty)
/// against the exact solution over `samples` random rays; fails where one is over its limit.
std::string run_verify(const std::string &path, int samples, std::uint64_t seed);

} // namespace blackhole
