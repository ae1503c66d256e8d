// SPDX-License-Identifier: MIT
#include "godot_cpp/classes/wrapped.hpp"

#include "godot_cpp/classes/object.hpp"
#include "godot_provider/call.hpp"

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace godot {
namespace internal {

namespace {

// Wrappers of engine objects that were met (not created) by us, so that unloading can detach them.
struct WrapperRegistry {
	std::mutex mutex;
	std::unordered_set<Wrapped *> met;
	std::unordered_map<const void *, const GDExtensionInstanceBindingCallbacks *> callbacks; // by class name
	std::vector<StringName> names; // keeps the keys of `callbacks` interned
};

WrapperRegistry &registry() {
	static WrapperRegistry instance;
	return instance;
}

StringName parent_class(const StringName &name) {
	static const GDExtensionObjectPtr class_db = [] {
		const StringName singleton("ClassDB");
		return api.global_get_singleton(singleton._native_ptr());
	}();
	static const GDExtensionMethodBindPtr method =
			method_bind("ClassDB", "get_parent_class", kHashGetParentClass);
	return call_method<StringName>(method, class_db, name);
}

// How objects of class `name` are wrapped; null when the class is not listed.
const GDExtensionInstanceBindingCallbacks *known_callbacks(const StringName &name) {
	const std::lock_guard lock(registry().mutex);
	const auto found = registry().callbacks.find(name.identity());
	return found == registry().callbacks.end() ? nullptr : found->second;
}

// How an object is wrapped: as the nearest listed class of its ancestors.
const GDExtensionInstanceBindingCallbacks *callbacks_of(GDExtensionObjectPtr object) {
	StringName name;
	api.object_get_class_name(object, library, name._native_ptr());
	const StringName asked = name;
	const GDExtensionInstanceBindingCallbacks *callbacks = known_callbacks(name);
	while (callbacks == nullptr) {
		name = name == StringName() ? Object::get_class_static()
									: parent_class(name); // Object is always listed
		callbacks = known_callbacks(name);
	}
	if (asked != name) {
		register_engine_class(asked, callbacks); // answers at once the next time
	}
	return callbacks;
}

} // namespace

ConstructionOrder &construction_order() {
	static thread_local ConstructionOrder order;
	return order;
}

Wrapped *wrapper_of(GDExtensionObjectPtr object) {
	if (object == nullptr) {
		return nullptr;
	}
	void *wrapper = api.object_get_instance_binding(object, library, nullptr);
	if (wrapper == nullptr) {
		wrapper = api.object_get_instance_binding(object, library, callbacks_of(object));
	}
	return static_cast<Wrapped *>(wrapper);
}

void register_engine_class(const StringName &name, const GDExtensionInstanceBindingCallbacks *callbacks) {
	const std::lock_guard lock(registry().mutex);
	registry().names.push_back(name);
	registry().callbacks.emplace(name.identity(), callbacks);
}

void send_postinitialize(Wrapped &object) {
	static const GDExtensionMethodBindPtr method = method_bind("Object", "notification", kHashNotification);
	call_method<void>(
			method, object._owner, static_cast<std::int32_t>(Object::NOTIFICATION_POSTINITIALIZE), false);
}

void release_all_wrappers() {
	std::vector<GDExtensionObjectPtr> owners;
	{
		const std::lock_guard lock(registry().mutex);
		for (const Wrapped *wrapper : registry().met) {
			owners.push_back(wrapper->_owner);
		}
	}
	for (GDExtensionObjectPtr owner : owners) {
		api.object_free_instance_binding(owner, library);
	}
	const std::lock_guard lock(registry().mutex);
	registry().callbacks.clear();
	registry().names.clear();
}

std::size_t live_wrapper_count() {
	const std::lock_guard lock(registry().mutex);
	return registry().met.size();
}

} // namespace internal

Wrapped::Wrapped() {
	const internal::ConstructionOrder order = std::exchange(internal::construction_order(), {});
	if (!order.pending) {
		std::fputs("A Godot object was constructed without memnew().\n", stderr);
		std::abort();
	}
	_owner = order.existing;
	if (_owner == nullptr) {
		_owner = internal::api.classdb_construct_object2(order.engine_class->_native_ptr());
	}
	if (order.extension_class == nullptr) {
		const std::lock_guard lock(internal::registry().mutex);
		internal::registry().met.insert(this);
	} else if (order.existing == nullptr) {
		internal::api.object_set_instance(_owner, order.extension_class->_native_ptr(), this);
	}
	if (order.callbacks != nullptr) {
		internal::api.object_set_instance_binding(_owner, internal::library, this, order.callbacks);
	}
}

Wrapped::~Wrapped() {
	const std::lock_guard lock(internal::registry().mutex);
	internal::registry().met.erase(this);
}

} // namespace godot
