// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace blackhole {

/// `blackhole-lut eval`: reads the inputs of reference table `name` from in_path, writes all its columns to
/// out_path with 17 digits; exact, or with the rays of the lensing tables in table_path if that is not empty.
/// Returns an error message, empty on success.
std::string run_eval(const std::string &name, const std::string &in_path, const std::string &out_path,
		const std::string &table_path);

} // namespace blackhole
