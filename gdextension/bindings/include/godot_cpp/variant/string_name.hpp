// SPDX-License-Identifier: MIT
#pragma once

#include "godot_provider/generated/string_name_methods.hpp"

namespace godot {

class String;

// An interned name: comparing two costs one pointer comparison.
class StringName : public internal::StringNameMethods {
public:
	StringName() = default;
	StringName(const char *latin1);
	StringName(const String &text);

	bool operator==(const StringName &other) const { return identity() == other.identity(); }
	bool operator!=(const StringName &other) const { return identity() != other.identity(); }
	bool operator<(const StringName &other) const { return identity() < other.identity(); }

	// The same for equal names, for as long as one of them lives.
	const void *identity() const { return *static_cast<const void *const *>(_native_ptr()); }
};

} // namespace godot
