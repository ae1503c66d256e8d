// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/property_info.hpp"
#include "godot_cpp/templates/list.hpp"
#include "godot_provider/class_access.hpp"
#include "godot_provider/static_name.hpp"
#include "godot_provider/wrappers.hpp"

namespace godot {

// Base of all classes that stand for engine objects. Create objects with memnew() only.
class Wrapped {
public:
	Wrapped(const Wrapped &) = delete;
	Wrapped &operator=(const Wrapped &) = delete;

	// The engine's object; leave it to the bindings.
	GDExtensionObjectPtr _owner = nullptr;

	// The object as a T, or null when it is none.
	template <class T>
	static T *cast_to(Wrapped *object) {
		return dynamic_cast<T *>(object);
	}
	template <class T>
	static const T *cast_to(const Wrapped *object) {
		return dynamic_cast<const T *>(object);
	}

protected:
	Wrapped();
	virtual ~Wrapped();

	// Overridable by declaring the same function in a class with GDCLASS; each class of the chain is asked.
	void _notification(int /*what*/) {}
	bool _set(const StringName & /*name*/, const Variant & /*value*/) { return false; }
	bool _get(const StringName & /*name*/, Variant & /*result*/) const { return false; }
	void _get_property_list(List<PropertyInfo> * /*list*/) const {}
	void _validate_property(PropertyInfo & /*property*/) const {}
	bool _property_can_revert(const StringName & /*name*/) const { return false; }
	bool _property_get_revert(const StringName & /*name*/, Variant & /*result*/) const { return false; }
	String _to_string() const { return String(); }
	static void _bind_methods() {}

private:
	friend struct internal::ClassAccess;
};

} // namespace godot

// Heads each of our own classes: GDCLASS(Name, Parent) with the parent an engine class or one of ours.
#define GDCLASS(m_class, m_inherits)                                                                         \
private:                                                                                                     \
	friend struct ::godot::internal::ClassAccess;                                                            \
                                                                                                             \
public:                                                                                                      \
	using self_type = m_class;                                                                               \
	using parent_type = m_inherits;                                                                          \
	static const ::godot::StringName &get_class_static() {                                                   \
		static ::godot::internal::StaticName name(#m_class);                                                 \
		return name.get();                                                                                   \
	}                                                                                                        \
	static const ::godot::StringName &get_parent_class_static() {                                            \
		return m_inherits::get_class_static();                                                               \
	}                                                                                                        \
                                                                                                             \
private:

// Heads each generated engine class.
#define GODOT_PROVIDER_ENGINE_CLASS(m_class, m_inherits)                                                     \
private:                                                                                                     \
	friend struct ::godot::internal::ClassAccess;                                                            \
                                                                                                             \
public:                                                                                                      \
	using self_type = m_class;                                                                               \
	using parent_type = m_inherits;                                                                          \
	using engine_class = m_class;                                                                            \
	static const ::godot::StringName &get_class_static() {                                                   \
		static ::godot::internal::StaticName name(#m_class);                                                 \
		return name.get();                                                                                   \
	}                                                                                                        \
                                                                                                             \
private:
