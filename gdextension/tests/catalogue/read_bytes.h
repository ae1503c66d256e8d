// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace blackhole {

/// The whole file at p_path, empty when it cannot be read.
inline std::vector<std::uint8_t> read_bytes(const std::string &p_path) {
	std::ifstream stream(p_path, std::ios::binary);
	return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

} // namespace blackhole
