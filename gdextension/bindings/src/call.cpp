// SPDX-License-Identifier: MIT
#include "godot_provider/call.hpp"

#include "godot_cpp/core/error_macros.hpp"

#include <vector>

namespace godot::internal {

namespace {

std::vector<const void *> addresses(const Variant *arguments, std::size_t count) {
	std::vector<const void *> result;
	result.reserve(count);
	for (std::size_t index = 0; index < count; ++index) {
		result.push_back(arguments[index]._native_ptr());
	}
	return result;
}

} // namespace

Variant call_method_variants(GDExtensionMethodBindPtr method, GDExtensionObjectPtr object,
		const Variant *arguments, std::size_t count) {
	Variant result;
	GDExtensionCallError error = {GDEXTENSION_CALL_OK, 0, 0};
	const std::vector<const void *> pointers = addresses(arguments, count);
	api.object_method_bind_call(method, object, pointers.data(), static_cast<GDExtensionInt>(count),
			result._native_ptr(), &error);
	ERR_FAIL_COND_V_MSG(error.error != GDEXTENSION_CALL_OK, Variant(),
			vformat("The engine refused the call: error %d, argument %d, expected %d.",
					static_cast<int>(error.error), error.argument, error.expected));
	return result;
}

void call_utility_variants(GDExtensionPtrUtilityFunction function, Variant *result, const Variant *arguments,
		std::size_t count) {
	const std::vector<const void *> pointers = addresses(arguments, count);
	function(result == nullptr ? nullptr : result->_native_ptr(), pointers.data(), static_cast<int>(count));
}

GDExtensionMethodBindPtr method_bind(const char *class_name, const char *method, GDExtensionInt hash) {
	const StringName class_text(class_name);
	const StringName method_text(method);
	const GDExtensionMethodBindPtr bind =
			api.classdb_get_method_bind(class_text._native_ptr(), method_text._native_ptr(), hash);
	CRASH_COND_MSG(bind == nullptr,
			vformat("This Godot has no %s.%s() as the extension knows it; build the extension for this "
					"version.",
					class_name, method));
	return bind;
}

GDExtensionPtrUtilityFunction utility_function(const char *name, GDExtensionInt hash) {
	const StringName text(name);
	return api.variant_get_ptr_utility_function(text._native_ptr(), hash);
}

} // namespace godot::internal
