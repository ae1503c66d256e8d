// SPDX-License-Identifier: MIT
// Calls from C++ into the engine.
#pragma once

#include "godot_provider/builtin.hpp"
#include "godot_provider/marshal.hpp"

#include <array>
#include <tuple>
#include <vector>

namespace godot::internal {

// Addresses of a list of outgoing arguments; the arguments must outlive it.
template <class... Arguments>
class OutArguments {
public:
	explicit OutArguments(const Arguments &...arguments) : slots_(arguments...) {
		std::apply([this](const auto &...slot) { pointers_ = {slot.ptr()...}; }, slots_);
	}
	const GDExtensionConstTypePtr *data() const { return pointers_.data(); }
	static constexpr int count() { return static_cast<int>(sizeof...(Arguments)); }

private:
	std::tuple<typename Marshal<Arguments>::Out...> slots_;
	std::array<GDExtensionConstTypePtr, sizeof...(Arguments) + 1> pointers_ = {};
};

// A method of a built-in type; self is null for static methods.
template <class Return, class... Arguments>
Return call_builtin(
		GDExtensionPtrBuiltInMethod method, GDExtensionTypePtr self, const Arguments &...arguments) {
	const OutArguments<Arguments...> slots(arguments...);
	if constexpr (std::is_void_v<Return>) {
		method(self, slots.data(), nullptr, slots.count());
	} else {
		typename Marshal<Return>::Result result;
		method(self, slots.data(), result.ptr(), slots.count());
		return result.take();
	}
}

// A method of a built-in type that takes any number of Variants.
template <class Return>
Return call_builtin_variants(GDExtensionPtrBuiltInMethod method, GDExtensionTypePtr self,
		const Variant *arguments, std::size_t count) {
	std::vector<const void *> pointers;
	for (std::size_t index = 0; index < count; ++index) {
		pointers.push_back(arguments[index]._native_ptr());
	}
	if constexpr (std::is_void_v<Return>) {
		method(self, pointers.data(), nullptr, static_cast<int>(count));
	} else {
		typename Marshal<Return>::Result result;
		method(self, pointers.data(), result.ptr(), static_cast<int>(count));
		return result.take();
	}
}

// A method of an engine class, by the fast path without Variants; object is null for static methods.
template <class Return, class... Arguments>
Return call_method(
		GDExtensionMethodBindPtr method, GDExtensionObjectPtr object, const Arguments &...arguments) {
	const OutArguments<Arguments...> slots(arguments...);
	if constexpr (std::is_void_v<Return>) {
		api.object_method_bind_ptrcall(method, object, slots.data(), nullptr);
	} else {
		typename Marshal<Return>::Result result;
		api.object_method_bind_ptrcall(method, object, slots.data(), result.ptr());
		return result.take();
	}
}

// A method of an engine class that takes any number of Variants. Errors are printed and give nil.
Variant call_method_variants(GDExtensionMethodBindPtr method, GDExtensionObjectPtr object,
		const Variant *arguments, std::size_t count);

// A utility function that takes any number of Variants.
void call_utility_variants(
		GDExtensionPtrUtilityFunction function, Variant *result, const Variant *arguments, std::size_t count);

// The engine's method; `hash` is the one in extension_api.json. Null (reported) when the engine lacks it.
GDExtensionMethodBindPtr method_bind(const char *class_name, const char *method, GDExtensionInt hash);

// A function of @GlobalScope; `hash` is the one in extension_api.json.
GDExtensionPtrUtilityFunction utility_function(const char *name, GDExtensionInt hash);

} // namespace godot::internal
