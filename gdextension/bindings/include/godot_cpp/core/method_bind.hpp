// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/binder_common.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace godot {

// One bound method: what the engine needs to know about it and how to call it.
class MethodBind {
public:
	virtual ~MethodBind() = default;
	MethodBind(const MethodBind &) = delete;
	MethodBind &operator=(const MethodBind &) = delete;

	const StringName &get_name() const { return name_; }
	int get_argument_count() const { return static_cast<int>(arguments_.size()); }

	// Names the method and its arguments (as many as are given) and sets the defaults of the last ones.
	void _set_names(const StringName &name, const std::vector<StringName> &arguments);
	void _set_defaults(std::vector<Variant> defaults) { defaults_ = std::move(defaults); }
	void _register(const StringName &class_name);

protected:
	MethodBind(PropertyInfo result, GDExtensionClassMethodArgumentMetadata result_metadata, bool has_result,
			std::vector<PropertyInfo> arguments,
			std::vector<GDExtensionClassMethodArgumentMetadata> argument_metadata, std::uint32_t flags);

	// Index of the first argument that does not fit its type, or -1. All arguments are present.
	virtual int first_misfit(const Variant *const *arguments) const = 0;
	virtual void invoke(Wrapped *instance, const Variant *const *arguments, Variant &result) const = 0;
	virtual void invoke_raw(
			Wrapped *instance, const GDExtensionConstTypePtr *arguments, GDExtensionTypePtr result) const = 0;

private:
	void call(Wrapped *instance, std::span<const GDExtensionConstVariantPtr> arguments, Variant &result,
			GDExtensionCallError &error) const;

	StringName name_;
	PropertyInfo result_;
	GDExtensionClassMethodArgumentMetadata result_metadata_;
	bool has_result_;
	std::vector<PropertyInfo> arguments_;
	std::vector<GDExtensionClassMethodArgumentMetadata> argument_metadata_;
	std::vector<Variant> defaults_;
	std::uint32_t flags_;
};

namespace internal {

// A parameter as it is stored and converted: without const and reference.
template <class T>
using Plain = std::remove_cvref_t<T>;

// Calls `function` with arguments from Variants; all must fit.
template <class Return, class... Arguments, class Function, std::size_t... kIndex>
void call_with_variants([[maybe_unused]] const Variant *const *arguments, Variant &result,
		const Function &function, std::index_sequence<kIndex...> /*indices*/) {
	if constexpr (std::is_void_v<Return>) {
		function(Marshal<Plain<Arguments>>::from_variant(*arguments[kIndex])...);
		result = Variant();
	} else {
		result = Variant(function(Marshal<Plain<Arguments>>::from_variant(*arguments[kIndex])...));
	}
}

// Calls `function` with arguments in the engine's own layout; values are passed on by reference.
template <class Return, class... Arguments, class Function, std::size_t... kIndex>
void call_with_slots([[maybe_unused]] const GDExtensionConstTypePtr *arguments,
		[[maybe_unused]] GDExtensionTypePtr result, const Function &function,
		std::index_sequence<kIndex...> /*indices*/) {
	if constexpr (std::is_void_v<Return>) {
		function(Marshal<Plain<Arguments>>::get(arguments[kIndex])...);
	} else {
		Marshal<Plain<Return>>::put(result, function(Marshal<Plain<Arguments>>::get(arguments[kIndex])...));
	}
}

template <class... Arguments, std::size_t... kIndex>
int first_misfit_of(
		[[maybe_unused]] const Variant *const *arguments, std::index_sequence<kIndex...> /*indices*/) {
	int misfit = -1;
	(void)((Marshal<Plain<Arguments>>::accepts(*arguments[kIndex]) ||
				   (misfit = static_cast<int>(kIndex), false)) &&
			...);
	return misfit;
}

template <class Return>
PropertyInfo describe_result() {
	if constexpr (std::is_void_v<Return>) {
		return PropertyInfo();
	} else {
		return describe<Plain<Return>>(StringName());
	}
}

template <class Return>
constexpr GDExtensionClassMethodArgumentMetadata result_metadata() {
	if constexpr (std::is_void_v<Return>) {
		return GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	} else {
		return Marshal<Plain<Return>>::kMetadata;
	}
}

// Class: the class whose instance is called, void for static functions.
template <class Class, class Function, class Return, class... Arguments>
class TypedMethodBind : public MethodBind {
public:
	TypedMethodBind(Function function, std::uint32_t flags)
			: MethodBind(describe_result<Return>(), result_metadata<Return>(), !std::is_void_v<Return>,
					  {describe<Plain<Arguments>>(StringName())...},
					  {Marshal<Plain<Arguments>>::kMetadata...}, flags),
			  function_(function) {
		static_assert(((!std::is_lvalue_reference_v<Arguments> ||
							  std::is_const_v<std::remove_reference_t<Arguments>>)&&...),
				"a bound method takes its arguments by value or by constant reference");
	}

protected:
	int first_misfit(const Variant *const *arguments) const override {
		return first_misfit_of<Arguments...>(arguments, std::index_sequence_for<Arguments...>());
	}
	void invoke(Wrapped *instance, const Variant *const *arguments, Variant &result) const override {
		call_with_variants<Return, Arguments...>(
				arguments, result, target(instance), std::index_sequence_for<Arguments...>());
	}
	void invoke_raw(Wrapped *instance, const GDExtensionConstTypePtr *arguments,
			GDExtensionTypePtr result) const override {
		call_with_slots<Return, Arguments...>(
				arguments, result, target(instance), std::index_sequence_for<Arguments...>());
	}

private:
	auto target([[maybe_unused]] Wrapped *instance) const {
		if constexpr (std::is_void_v<Class>) {
			return function_;
		} else {
			return [function = function_, object = static_cast<Class *>(instance)](
						   auto &&...arguments) -> Return {
				return (object->*function)(std::forward<decltype(arguments)>(arguments)...);
			};
		}
	}

	Function function_;
};

template <class Class, class Return, class... Arguments>
std::unique_ptr<MethodBind> make_method_bind(Return (Class::*function)(Arguments...)) {
	return std::make_unique<TypedMethodBind<Class, decltype(function), Return, Arguments...>>(
			function, GDEXTENSION_METHOD_FLAGS_DEFAULT);
}
template <class Class, class Return, class... Arguments>
std::unique_ptr<MethodBind> make_method_bind(Return (Class::*function)(Arguments...) const) {
	return std::make_unique<TypedMethodBind<Class, decltype(function), Return, Arguments...>>(
			function, GDEXTENSION_METHOD_FLAGS_DEFAULT | GDEXTENSION_METHOD_FLAG_CONST);
}
template <class Return, class... Arguments>
std::unique_ptr<MethodBind> make_method_bind(Return (*function)(Arguments...)) {
	return std::make_unique<TypedMethodBind<void, decltype(function), Return, Arguments...>>(
			function, GDEXTENSION_METHOD_FLAGS_DEFAULT | GDEXTENSION_METHOD_FLAG_STATIC);
}

} // namespace internal
} // namespace godot
