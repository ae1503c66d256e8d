// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/variant.hpp"

namespace godot::internal {

// The engine's name for the element type of a TypedArray: a built-in type, or a class by name.
template <class T>
struct ElementType {
	static constexpr Variant::Type kType = Variant::OBJECT;
	static StringName class_name() { return T::get_class_static(); }
};

template <class T>
struct ElementType<Ref<T>> : ElementType<T> {};

template <Variant::Type kVariantType>
struct BuiltinElement {
	static constexpr Variant::Type kType = kVariantType;
	static StringName class_name() { return StringName(); }
};

template <>
struct ElementType<bool> : BuiltinElement<Variant::BOOL> {};
template <std::integral T>
struct ElementType<T> : BuiltinElement<Variant::INT> {};
template <std::floating_point T>
struct ElementType<T> : BuiltinElement<Variant::FLOAT> {};

#define GODOT_PROVIDER_ELEMENT(type, tag)                                                                    \
	template <>                                                                                              \
	struct ElementType<type> : BuiltinElement<Variant::tag> {};
GODOT_PROVIDER_VALUE_TYPES(GODOT_PROVIDER_ELEMENT)
#undef GODOT_PROVIDER_ELEMENT

} // namespace godot::internal
