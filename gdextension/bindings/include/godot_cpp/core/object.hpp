// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/classes/object.hpp"
#include "godot_cpp/core/memory.hpp"

#include <vector>

namespace godot {

// Name, arguments and return value of a method or signal.
struct MethodInfo {
	StringName name;
	PropertyInfo return_val;
	std::vector<PropertyInfo> arguments;

	MethodInfo() = default;
	template <class... Arguments>
	MethodInfo(const StringName &p_name, const Arguments &...p_arguments)
			: name(p_name), arguments({p_arguments...}) {}
};

// Finds living objects.
class ObjectDB {
public:
	// The object, or null when it has been freed.
	static Object *get_instance(std::uint64_t id) {
		return Object::cast_to<Object>(internal::wrapper_of(internal::api.object_get_instance_from_id(id)));
	}
};

} // namespace godot

#define ADD_SIGNAL(m_signal) ::godot::ClassDB::add_signal(get_class_static(), m_signal)
#define ADD_GROUP(m_name, m_prefix) ::godot::ClassDB::add_property_group(get_class_static(), m_name, m_prefix)
#define ADD_SUBGROUP(m_name, m_prefix)                                                                       \
	::godot::ClassDB::add_property_subgroup(get_class_static(), m_name, m_prefix)
#define ADD_PROPERTY(m_property, m_setter, m_getter)                                                         \
	::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter)
#define ADD_PROPERTYI(m_property, m_setter, m_getter, m_index)                                               \
	::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter, m_index)
