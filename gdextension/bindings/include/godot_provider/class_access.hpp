// SPDX-License-Identifier: MIT
// The one door through which the bindings reach the protected parts of a class: construction and destruction.
#pragma once

#include "godot_provider/wrappers.hpp"

#include <type_traits>

namespace godot::internal {

// Friend of every class with GDCLASS.
struct ClassAccess {
	// Tells the constructor of Wrapped that a new T follows.
	template <class T>
	static void prepare(GDExtensionObjectPtr existing = nullptr) {
		static_assert(std::is_same_v<T, typename T::self_type>, "GDCLASS is missing in this class");
		ConstructionOrder &order = construction_order();
		order = {};
		order.pending = true;
		order.existing = existing;
		order.engine_class = &T::engine_class::get_class_static();
		if constexpr (is_engine_class<T>()) {
			order.callbacks = &kEngineCallbacks<T>;
		} else {
			order.extension_class = &T::get_class_static();
			order.callbacks = &kExtensionCallbacks;
		}
	}

	template <class T>
	static T *construct() {
		prepare<T>();
		return new T;
	}

	// One of our objects for an engine object that exists already (the library has been reloaded).
	template <class T>
	static T *reconstruct(GDExtensionObjectPtr existing) {
		prepare<T>(existing);
		return new T;
	}

	template <class T>
	static constexpr bool is_engine_class() {
		return std::is_same_v<T, typename T::engine_class>;
	}

	// Instance callbacks: the engine asks for a wrapper of one of its objects, and frees it with the object.
	template <class T>
	static void *create_wrapper(void * /*token*/, void *object) {
		ConstructionOrder &order = construction_order();
		order = {};
		order.pending = true;
		order.existing = object;
		return as_wrapped(new T);
	}
	static void free_wrapper(void * /*token*/, void * /*object*/, void *wrapper) { destroy_wrapper(wrapper); }
	static GDExtensionBool reference_wrapper(
			void * /*token*/, void * /*wrapper*/, GDExtensionBool /*reference*/) {
		return 1;
	}

	// How the engine makes and frees the wrapper of an object of engine class T.
	template <class T>
	static inline const GDExtensionInstanceBindingCallbacks kEngineCallbacks = {
			&create_wrapper<T>, &free_wrapper, &reference_wrapper};

	// An object of our own classes is its own wrapper: the engine frees it through free_instance_func.
	static const GDExtensionInstanceBindingCallbacks kExtensionCallbacks;

	static void *as_wrapped(Wrapped *wrapper) { return wrapper; }
	static void destroy_wrapper(void *wrapper);

// Pointers to the protected functions of T, own or inherited.
#define GODOT_PROVIDER_POINTER(function)                                                                     \
	template <class T>                                                                                       \
	static constexpr auto pointer##function() {                                                              \
		return &T::function;                                                                                 \
	}
	GODOT_PROVIDER_POINTER(_notification)
	GODOT_PROVIDER_POINTER(_set)
	GODOT_PROVIDER_POINTER(_get)
	GODOT_PROVIDER_POINTER(_get_property_list)
	GODOT_PROVIDER_POINTER(_validate_property)
	GODOT_PROVIDER_POINTER(_property_can_revert)
	GODOT_PROVIDER_POINTER(_property_get_revert)
	GODOT_PROVIDER_POINTER(_to_string)
	GODOT_PROVIDER_POINTER(_bind_methods)
#undef GODOT_PROVIDER_POINTER
};

} // namespace godot::internal
