// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/classes/global_constants.hpp"
#include "godot_cpp/variant/variant.hpp"

namespace godot {

// Name, type and editor hints of a property, argument or return value.
struct PropertyInfo {
	Variant::Type type = Variant::NIL;
	StringName name;
	StringName class_name;
	std::uint32_t hint = PROPERTY_HINT_NONE;
	String hint_string;
	std::uint32_t usage = PROPERTY_USAGE_DEFAULT;

	PropertyInfo() = default;
	PropertyInfo(Variant::Type p_type, const StringName &p_name, PropertyHint p_hint = PROPERTY_HINT_NONE,
			const String &p_hint_string = "", std::uint32_t p_usage = PROPERTY_USAGE_DEFAULT,
			const StringName &p_class_name = "")
			: type(p_type), name(p_name),
			  class_name(p_hint == PROPERTY_HINT_RESOURCE_TYPE ? StringName(p_hint_string) : p_class_name),
			  hint(p_hint), hint_string(p_hint_string), usage(p_usage) {}

	// The engine's form; it points into this object.
	GDExtensionPropertyInfo _to_gdextension() const {
		return {static_cast<GDExtensionVariantType>(type), name._native_ptr(), class_name._native_ptr(), hint,
				hint_string._native_ptr(), usage};
	}
};

} // namespace godot
