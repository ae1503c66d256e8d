// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <godot_cpp/variant/packed_byte_array.hpp>

/// The bytes of a packed array, which must outlive the view.
inline std::span<const std::uint8_t> bytes_of(const godot::PackedByteArray &bytes) {
	return {bytes.ptr(), static_cast<std::size_t>(bytes.size())};
}

/// The same as text.
inline std::string_view text_of(const godot::PackedByteArray &bytes) {
	return {reinterpret_cast<const char *>(bytes.ptr()), static_cast<std::size_t>(bytes.size())};
}
