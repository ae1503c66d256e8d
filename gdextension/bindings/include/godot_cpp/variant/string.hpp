// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/char_string.hpp"
#include "godot_provider/generated/string_methods.hpp"

namespace godot {

class Array;
class NodePath;
class StringName;
class Variant;

// The engine's text type (UTF-32, copied on write).
class String : public internal::StringMethods {
public:
	String() = default;
	String(const char *latin1);
	String(const char32_t *text);
	String(const wchar_t *text);
	String(const StringName &name);
	String(const NodePath &path);

	// Reads UTF-8; length in bytes, -1 for zero-terminated text.
	static String utf8(const char *text, std::int64_t length = -1);

	CharString utf8() const;
	CharString ascii(bool extended = false) const; // extended: Latin-1 rather than ASCII

	String operator+(const String &other) const;
	String &operator+=(const String &other);
	String operator%(const Variant &arguments) const; // printf-style, as in GDScript
	bool operator==(const String &other) const;
	bool operator!=(const String &other) const { return !(*this == other); }
	bool operator<(const String &other) const;
	const char32_t &operator[](std::int64_t index) const;
};

inline bool operator==(const char *text, const String &other) {
	return other == String(text);
}
inline bool operator!=(const char *text, const String &other) {
	return !(text == other);
}
inline String operator+(const char *text, const String &other) {
	return String(text) + other;
}

} // namespace godot
