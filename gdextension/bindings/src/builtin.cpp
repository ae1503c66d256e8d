// SPDX-License-Identifier: MIT
#include "godot_provider/builtin.hpp"

#include "godot_cpp/variant/string_name.hpp"

namespace godot::internal {

std::array<BuiltinFunctions, GDEXTENSION_VARIANT_TYPE_VARIANT_MAX> builtin_functions;

void load_builtin_functions() {
	for (int index = 1; index < GDEXTENSION_VARIANT_TYPE_VARIANT_MAX; ++index) {
		const auto type = static_cast<GDExtensionVariantType>(index);
		BuiltinFunctions &functions = builtin_functions[static_cast<std::size_t>(index)];
		functions.to_variant = api.get_variant_from_type_constructor(type);
		functions.from_variant = api.get_variant_to_type_constructor(type);
		if (type == GDEXTENSION_VARIANT_TYPE_OBJECT) {
			continue; // objects are pointers: no constructor, no destructor
		}
		functions.construct = api.variant_get_ptr_constructor(type, 0);
		functions.copy = api.variant_get_ptr_constructor(type, 1);
		functions.destroy = api.variant_get_ptr_destructor(type);
	}
}

GDExtensionPtrBuiltInMethod builtin_method(
		GDExtensionVariantType type, const char *name, GDExtensionInt hash) {
	const StringName method(name);
	return api.variant_get_ptr_builtin_method(type, method._native_ptr(), hash);
}

} // namespace godot::internal
