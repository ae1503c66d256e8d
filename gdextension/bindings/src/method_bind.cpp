// SPDX-License-Identifier: MIT
#include "godot_cpp/core/method_bind.hpp"

#include "godot_provider/builtin.hpp"

#include <string_view>

namespace godot {

namespace internal {

namespace {

// The last `parts` components of a name written with "::" or ".", joined by ".".
std::string last_components(std::string_view name, int parts) {
	std::string joined;
	while (parts-- > 0 && !name.empty()) {
		const std::size_t cut = name.find_last_of(":.");
		const std::string_view part = cut == std::string_view::npos ? name : name.substr(cut + 1);
		joined = joined.empty() ? std::string(part) : std::string(part) + "." + joined;
		const std::size_t end =
				cut == std::string_view::npos ? std::string_view::npos : name.find_last_not_of(":.", cut);
		name = end == std::string_view::npos ? std::string_view() : name.substr(0, end + 1);
	}
	return joined;
}

} // namespace

StringName enum_class_name(const char *qualified_name) {
	return StringName(last_components(qualified_name, 2).c_str());
}

StringName enum_short_name(const char *qualified_name) {
	return StringName(last_components(qualified_name, 1).c_str());
}

} // namespace internal

MethodBind::MethodBind(PropertyInfo result, GDExtensionClassMethodArgumentMetadata result_metadata,
		bool has_result, std::vector<PropertyInfo> arguments,
		std::vector<GDExtensionClassMethodArgumentMetadata> argument_metadata, std::uint32_t flags)
		: result_(std::move(result)), result_metadata_(result_metadata), has_result_(has_result),
		  arguments_(std::move(arguments)), argument_metadata_(std::move(argument_metadata)), flags_(flags) {}

void MethodBind::_set_names(const StringName &name, const std::vector<StringName> &arguments) {
	name_ = name;
	for (std::size_t index = 0; index < arguments_.size(); ++index) {
		const String fallback = String("arg") + String::num_int64(static_cast<std::int64_t>(index));
		arguments_[index].name = index < arguments.size() ? arguments[index] : StringName(fallback);
	}
}

void MethodBind::call(Wrapped *instance, std::span<const GDExtensionConstVariantPtr> given, Variant &result,
		GDExtensionCallError &error) const {
	const std::size_t wanted = arguments_.size();
	if (given.size() > wanted) {
		error = {GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS, 0, static_cast<std::int32_t>(wanted)};
		return;
	}
	if (given.size() + defaults_.size() < wanted) {
		error = {GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS, 0,
				static_cast<std::int32_t>(wanted - defaults_.size())};
		return;
	}
	std::vector<const Variant *> arguments(wanted);
	for (std::size_t index = 0; index < wanted; ++index) {
		arguments[index] = index < given.size() ? static_cast<const Variant *>(given[index])
												: &defaults_[index + defaults_.size() - wanted];
	}
	const int misfit = first_misfit(arguments.data());
	if (misfit >= 0) {
		error = {GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT, misfit,
				static_cast<std::int32_t>(arguments_[static_cast<std::size_t>(misfit)].type)};
		return;
	}
	error.error = GDEXTENSION_CALL_OK;
	invoke(instance, arguments.data(), result);
}

void MethodBind::_register(const StringName &class_name) {
	std::vector<GDExtensionPropertyInfo> arguments;
	for (const PropertyInfo &argument : arguments_) {
		arguments.push_back(argument._to_gdextension());
	}
	std::vector<GDExtensionVariantPtr> defaults;
	for (const Variant &value : defaults_) {
		defaults.push_back(value._native_ptr());
	}
	GDExtensionPropertyInfo result = result_._to_gdextension();

	GDExtensionClassMethodInfo info = {};
	info.name = name_._native_ptr();
	info.method_userdata = this;
	info.call_func = [](void *bind, GDExtensionClassInstancePtr instance,
							 const GDExtensionConstVariantPtr *values, GDExtensionInt count,
							 GDExtensionVariantPtr return_value, GDExtensionCallError *error) {
		static_cast<const MethodBind *>(bind)->call(static_cast<Wrapped *>(instance),
				{values, static_cast<std::size_t>(count)}, *static_cast<Variant *>(return_value), *error);
	};
	info.ptrcall_func = [](void *bind, GDExtensionClassInstancePtr instance,
								const GDExtensionConstTypePtr *values, GDExtensionTypePtr return_value) {
		static_cast<const MethodBind *>(bind)->invoke_raw(
				static_cast<Wrapped *>(instance), values, return_value);
	};
	info.method_flags = flags_;
	info.has_return_value = has_result_ ? 1 : 0;
	info.return_value_info = &result;
	info.return_value_metadata = result_metadata_;
	info.argument_count = static_cast<std::uint32_t>(arguments.size());
	info.arguments_info = arguments.data();
	info.arguments_metadata = argument_metadata_.data();
	info.default_argument_count = static_cast<std::uint32_t>(defaults.size());
	info.default_arguments = defaults.data();
	internal::api.classdb_register_extension_class_method(internal::library, class_name._native_ptr(), &info);
}

} // namespace godot
