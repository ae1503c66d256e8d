// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/variant.hpp"
#include "godot_provider/element_type.hpp"

namespace godot {

// An Array whose elements the engine keeps to one type.
template <class T>
class TypedArray : public Array {
public:
	TypedArray() { declare_type(); }
	TypedArray(std::initializer_list<Variant> values) : TypedArray() { assign(Array(values)); }
	// Shares an array of the same type, copies any other (elements that do not fit are refused with an
	// error).
	TypedArray(const Array &array) : TypedArray() { *this = array; }
	TypedArray(const Variant &value) : TypedArray(static_cast<const Array &>(Array(value))) {}

	TypedArray &operator=(const Array &array) {
		if (is_same_typed(array)) {
			Array::operator=(array);
		} else {
			assign(array);
		}
		return *this;
	}

private:
	void declare_type() {
		using Element = internal::ElementType<T>;
		const Variant no_script;
		internal::api.array_set_typed(_native_ptr(), static_cast<GDExtensionVariantType>(Element::kType),
				Element::class_name()._native_ptr(), no_script._native_ptr());
	}
};

} // namespace godot
