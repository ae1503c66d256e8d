// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/classes/wrapped.hpp"

namespace godot::internal {

template <class T>
void prepare_new() {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		ClassAccess::prepare<T>();
	}
}

template <class T>
T *finish_new(T *object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		send_postinitialize(*object);
	}
	return object;
}

} // namespace godot::internal

// memnew(Type) or memnew(Type(arguments)): the only way to create an object of a Godot class.
#define memnew(m_class)                                                                                      \
	(::godot::internal::prepare_new<std::remove_pointer_t<decltype(new m_class)>>(),                         \
			::godot::internal::finish_new(new m_class))

namespace godot {

// Frees what memnew() made. References (Ref<T>) free themselves.
template <class T>
void memdelete(T *object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		internal::api.object_destroy(object->_owner);
	} else {
		delete object;
	}
}

} // namespace godot
