// SPDX-License-Identifier: MIT
// How a C++ type is described to the engine: Variant type, class or enumeration name, hint.
#pragma once

#include "godot_provider/enum_name.hpp"
#include "godot_provider/marshal_object.hpp"

namespace godot::internal {

// "Class.Enum", the engine's form, from the C++ name with any namespaces in front.
StringName enum_class_name(const char *qualified_name);

// "Enum" alone.
StringName enum_short_name(const char *qualified_name);

// Adds what is special about T to a plain description.
template <class T>
struct Describe {
	static void refine(PropertyInfo &info) {
		if constexpr (std::is_enum_v<T>) {
			if (EnumName<T>::kText != nullptr) {
				info.class_name = enum_class_name(EnumName<T>::kText);
				info.usage |= PROPERTY_USAGE_CLASS_IS_ENUM;
			}
		}
	}
};
template <>
struct Describe<Variant> {
	static void refine(PropertyInfo &info) { info.usage |= PROPERTY_USAGE_NIL_IS_VARIANT; }
};
template <class T>
struct Describe<BitField<T>> {
	static void refine(PropertyInfo &info) {
		if (EnumName<T>::kText != nullptr) {
			info.class_name = enum_class_name(EnumName<T>::kText);
			info.usage |= PROPERTY_USAGE_CLASS_IS_BITFIELD;
		}
	}
};
template <class T>
struct Describe<T *> {
	static void refine(PropertyInfo &info) { info.class_name = T::get_class_static(); }
};
template <class T>
struct Describe<Ref<T>> {
	static void refine(PropertyInfo &info) {
		info.hint = PROPERTY_HINT_RESOURCE_TYPE;
		info.hint_string = T::get_class_static();
		info.class_name = T::get_class_static();
	}
};
template <class T>
struct Describe<TypedArray<T>> {
	static void refine(PropertyInfo &info) {
		using Element = ElementType<T>;
		info.hint = PROPERTY_HINT_ARRAY_TYPE;
		info.hint_string = Element::kType == Variant::OBJECT ? String(Element::class_name())
															 : Variant::get_type_name(Element::kType);
	}
};

// The full description of an argument or return value of type T.
template <class T>
PropertyInfo describe(const StringName &name) {
	PropertyInfo info(Marshal<T>::kType, name);
	Describe<T>::refine(info);
	return info;
}

} // namespace godot::internal
