// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/error_macros.hpp"
#include "godot_cpp/core/method_bind.hpp"
#include "godot_cpp/core/object.hpp"
#include "godot_cpp/variant/callable_method_pointer.hpp"
#include "godot_provider/class_hooks.hpp"

#include <memory>

namespace godot {

// A method's name with the names of its arguments.
struct MethodDefinition {
	StringName name;
	std::vector<StringName> args;

	MethodDefinition() = default;
	MethodDefinition(const char *p_name) : name(p_name) {}
	MethodDefinition(const StringName &p_name) : name(p_name) {}
};

template <class... Names>
MethodDefinition D_METHOD(const StringName &name, const Names &...arguments) {
	MethodDefinition definition(name);
	definition.args = {StringName(arguments)...};
	return definition;
}

#define DEFVAL(m_value) (m_value)

// Registers classes and their members with the engine.
class ClassDB {
public:
	template <class T>
	static void register_class(bool is_virtual = false) {
		register_as<T>({.is_virtual = is_virtual});
	}
	template <class T>
	static void register_abstract_class() {
		register_as<T>({.is_abstract = true});
	}
	template <class T>
	static void register_internal_class() {
		register_as<T>({.is_exposed = false});
	}
	template <class T>
	static void register_runtime_class() {
		register_as<T>({.is_runtime = true});
	}

	// A method of the class being registered, with the default values of its last arguments.
	template <class Definition, class Function, class... Defaults>
	static MethodBind *bind_method(
			const Definition &definition, Function function, const Defaults &...defaults) {
		return add_method(
				current_class(), definition, internal::make_method_bind(function), {Variant(defaults)...});
	}
	template <class Definition, class Function, class... Defaults>
	static MethodBind *bind_static_method(const StringName &class_name, const Definition &definition,
			Function function, const Defaults &...defaults) {
		return add_method(
				class_name, definition, internal::make_method_bind(function), {Variant(defaults)...});
	}

	static void add_property(const StringName &class_name, const PropertyInfo &property,
			const StringName &setter, const StringName &getter, int index = -1);
	static void add_property_group(const StringName &class_name, const String &name, const String &prefix);
	static void add_property_subgroup(const StringName &class_name, const String &name, const String &prefix);
	static void add_signal(const StringName &class_name, const MethodInfo &signal);
	static void bind_integer_constant(const StringName &class_name, const StringName &enum_name,
			const StringName &name, std::int64_t value, bool is_bitfield = false);

	// For the bindings themselves.
	static void _bind_virtual(const char *name, std::uint32_t hash, GDExtensionClassCallVirtual function);
	static void _unregister_classes(GDExtensionInitializationLevel level);
	static void _set_level(GDExtensionInitializationLevel level);

private:
	struct Flags {
		bool is_virtual = false;
		bool is_abstract = false;
		bool is_exposed = true;
		bool is_runtime = false;
	};

	template <class T>
	static void register_as(const Flags &flags) {
		static_assert(std::is_same_v<T, typename T::self_type>, "GDCLASS is missing in this class");
		GDExtensionClassCreationInfo5 info = {};
		if constexpr (!std::is_abstract_v<T>) {
			info = internal::ClassHooks<T>::describe();
		}
		begin_class(T::get_class_static(), T::get_parent_class_static(), flags, info);
		using Parent = typename T::parent_type;
		if (internal::ClassAccess::pointer_bind_methods<T>() !=
				internal::ClassAccess::pointer_bind_methods<Parent>()) {
			internal::ClassAccess::pointer_bind_methods<T>()();
		}
		T::engine_class::template register_virtuals<T, Parent>();
		end_class();
	}

	static void begin_class(const StringName &name, const StringName &parent, const Flags &flags,
			GDExtensionClassCreationInfo5 &info);
	static void end_class();
	static const StringName &current_class();
	static MethodBind *add_method(const StringName &class_name, const MethodDefinition &definition,
			std::unique_ptr<MethodBind> method, std::vector<Variant> defaults);
};

namespace internal {

template <class T, class Return, class... Arguments>
void call_virtual_slots(Return (T::*function)(Arguments...), T *object,
		const GDExtensionConstTypePtr *arguments, GDExtensionTypePtr result) {
	call_with_slots<Return, Arguments...>(
			arguments, result,
			[&](auto &&...values) -> Return {
				return (object->*function)(std::forward<decltype(values)>(values)...);
			},
			std::index_sequence_for<Arguments...>());
}
template <class T, class Return, class... Arguments>
void call_virtual_slots(Return (T::*function)(Arguments...) const, T *object,
		const GDExtensionConstTypePtr *arguments, GDExtensionTypePtr result) {
	call_with_slots<Return, Arguments...>(
			arguments, result,
			[&](auto &&...values) -> Return {
				return (object->*function)(std::forward<decltype(values)>(values)...);
			},
			std::index_sequence_for<Arguments...>());
}

// Tells the engine that class T overrides one of its virtual methods.
template <class T, auto kFunction>
void bind_virtual(const char *name, std::uint32_t hash) {
	ClassDB::_bind_virtual(name, hash,
			[](GDExtensionClassInstancePtr instance, const GDExtensionConstTypePtr *arguments,
					GDExtensionTypePtr result) {
				call_virtual_slots(kFunction, instance_as<T>(instance), arguments, result);
			});
}

} // namespace internal
} // namespace godot

#define BIND_CONSTANT(m_constant)                                                                            \
	::godot::ClassDB::bind_integer_constant(get_class_static(), "", #m_constant, m_constant)
#define BIND_ENUM_CONSTANT(m_constant)                                                                       \
	::godot::ClassDB::bind_integer_constant(get_class_static(),                                              \
			::godot::internal::enum_short_name(::godot::internal::EnumName<decltype(m_constant)>::kText),    \
			#m_constant, m_constant)
#define BIND_BITFIELD_FLAG(m_constant)                                                                       \
	::godot::ClassDB::bind_integer_constant(get_class_static(),                                              \
			::godot::internal::enum_short_name(::godot::internal::EnumName<decltype(m_constant)>::kText),    \
			#m_constant, m_constant, true)

#define GDREGISTER_CLASS(m_class) ::godot::ClassDB::register_class<m_class>();
#define GDREGISTER_VIRTUAL_CLASS(m_class) ::godot::ClassDB::register_class<m_class>(true);
#define GDREGISTER_ABSTRACT_CLASS(m_class) ::godot::ClassDB::register_abstract_class<m_class>();
#define GDREGISTER_INTERNAL_CLASS(m_class) ::godot::ClassDB::register_internal_class<m_class>();
#define GDREGISTER_RUNTIME_CLASS(m_class) ::godot::ClassDB::register_runtime_class<m_class>();
