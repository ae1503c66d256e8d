// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace godot {

// Bytes of a String in some encoding, zero-terminated.
class CharString {
public:
	CharString() = default;
	explicit CharString(std::string bytes) : bytes_(std::move(bytes)) {}
	const char *get_data() const { return bytes_.c_str(); }
	const char *ptr() const { return bytes_.c_str(); }
	std::int64_t length() const { return static_cast<std::int64_t>(bytes_.size()); }
	char operator[](std::int64_t index) const { return bytes_[static_cast<std::size_t>(index)]; }

private:
	std::string bytes_;
};

} // namespace godot
