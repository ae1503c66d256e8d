// SPDX-License-Identifier: MIT
#include "godot_cpp/variant/callable_method_pointer.hpp"

#include <vector>

namespace godot::internal {

namespace {

const MethodCallable &method_at(void *userdata) {
	return *static_cast<const MethodCallable *>(userdata);
}

void call(void *userdata, const GDExtensionConstVariantPtr *values, GDExtensionInt count,
		GDExtensionVariantPtr result, GDExtensionCallError *error) {
	const MethodCallable &method = method_at(userdata);
	const int wanted = method.argument_count();
	if (count != wanted) {
		error->error = count < wanted ? GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS
									  : GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS;
		error->expected = wanted;
		return;
	}
	Wrapped *object = wrapper_of(api.object_get_instance_from_id(method.id()));
	if (object == nullptr) {
		error->error = GDEXTENSION_CALL_ERROR_INSTANCE_IS_NULL;
		return;
	}
	std::vector<const Variant *> arguments;
	for (GDExtensionInt index = 0; index < count; ++index) {
		arguments.push_back(static_cast<const Variant *>(values[index]));
	}
	const int misfit = method.first_misfit(arguments.data());
	if (misfit >= 0) {
		*error = {GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT, misfit,
				static_cast<std::int32_t>(method.argument_type(misfit))};
		return;
	}
	error->error = GDEXTENSION_CALL_OK;
	method.invoke(*object, arguments.data(), *static_cast<Variant *>(result));
}

GDExtensionBool is_valid(void *userdata) {
	return api.object_get_instance_from_id(method_at(userdata).id()) != nullptr ? 1 : 0;
}

void free_method(void *userdata) {
	const std::unique_ptr<MethodCallable> owned(static_cast<MethodCallable *>(userdata));
}

// Equal methods of one object must hash alike; few callables of one object are ever compared.
std::uint32_t hash(void *userdata) {
	const GDObjectInstanceID id = method_at(userdata).id();
	return static_cast<std::uint32_t>(id ^ (id >> 32U));
}

GDExtensionBool equal(void *left, void *right) {
	return method_at(left).same_as(method_at(right)) ? 1 : 0;
}

GDExtensionBool less_than(void *left, void *right) {
	return equal(left, right) == 0 && left < right ? 1 : 0;
}

GDExtensionInt argument_count(void *userdata, GDExtensionBool *valid) {
	*valid = 1;
	return method_at(userdata).argument_count();
}

} // namespace

Callable make_callable(std::unique_ptr<MethodCallable> method) {
	GDExtensionCallableCustomInfo2 info = {};
	info.token = library;
	info.object_id = method->id();
	info.callable_userdata = method.release();
	info.call_func = &call;
	info.is_valid_func = &is_valid;
	info.free_func = &free_method;
	info.hash_func = &hash;
	info.equal_func = &equal;
	info.less_than_func = &less_than;
	info.get_argument_count_func = &argument_count;
	return Callable(info);
}

} // namespace godot::internal
