// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace blackhole::fuzz {

/// Ends the program, which the fuzzer takes for a finding, unless the property holds.
inline void demand(bool holds, const std::string &property) {
	if (!holds) {
		std::fprintf(stderr, "broken: %s\n", property.c_str());
		std::abort();
	}
}

/// What is refused says why, and names the file.
inline void demand_reason(const std::string &error, const std::string &name) {
	demand(error.size() > name.size() + 10 && error.find(name) != std::string::npos,
			"a refusal names the file and says why: '" + error + "'");
}

} // namespace blackhole::fuzz
