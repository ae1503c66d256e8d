// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace blackhole {

/// A value, or the reason why there is none. The reason is a sentence for the user: it names the file and the
/// remedy.
template <class T>
struct Outcome {
	std::optional<T> value;
	std::string error;

	static Outcome success(T p_value) { return {std::move(p_value), {}}; }
	static Outcome failure(std::string p_error) { return {std::nullopt, std::move(p_error)}; }

	explicit operator bool() const { return value.has_value(); }
};

} // namespace blackhole
