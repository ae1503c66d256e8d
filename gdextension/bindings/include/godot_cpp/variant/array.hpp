// SPDX-License-Identifier: MIT
#pragma once

#include "godot_provider/generated/array_methods.hpp"

#include <initializer_list>

namespace godot {

class Variant;

// The engine's list of Variants, shared by reference.
class Array : public internal::ArrayMethods {
public:
	Array() = default;
	Array(std::initializer_list<Variant> values);

	template <class... Values>
	static Array make(const Values &...values);

	// The element, or a shared nil (with an error message) when out of range.
	const Variant &operator[](std::int64_t index) const;
	Variant &operator[](std::int64_t index);

	const Variant *ptr() const;
	Variant *ptrw();
	const Variant *begin() const;
	const Variant *end() const;

	bool operator==(const Array &other) const;
	bool operator!=(const Array &other) const { return !(*this == other); }
};

} // namespace godot
