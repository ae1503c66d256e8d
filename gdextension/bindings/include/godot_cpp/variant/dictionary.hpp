// SPDX-License-Identifier: MIT
#pragma once

#include "godot_provider/generated/dictionary_methods.hpp"

namespace godot {

class Variant;

// The engine's map of Variants, shared by reference.
class Dictionary : public internal::DictionaryMethods {
public:
	const Variant &operator[](const Variant &key) const;
	Variant &operator[](const Variant &key); // inserts nil when absent

	bool operator==(const Dictionary &other) const;
	bool operator!=(const Dictionary &other) const { return !(*this == other); }
};

} // namespace godot
