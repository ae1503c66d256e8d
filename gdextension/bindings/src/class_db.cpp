// SPDX-License-Identifier: MIT
#include "godot_cpp/core/class_db.hpp"

#include <cstdio>
#include <unordered_map>

namespace godot {

namespace {

struct VirtualMethod {
	StringName name; // keeps the key interned
	std::uint32_t hash = 0;
	GDExtensionClassCallVirtual function = nullptr;
};

// One of our classes; the engine holds its address as class_userdata.
struct ClassEntry {
	StringName name;
	const ClassEntry *parent = nullptr; // null: an engine class
	GDExtensionInitializationLevel level = GDEXTENSION_INITIALIZATION_CORE;
	std::unordered_map<const void *, VirtualMethod> virtuals;
	std::vector<std::unique_ptr<MethodBind>> methods;
};

// Classes in the order of registration, parents before children. Touched on the main thread only.
std::vector<std::unique_ptr<ClassEntry>> classes;
ClassEntry *current = nullptr;
GDExtensionInitializationLevel current_level = GDEXTENSION_INITIALIZATION_CORE;

ClassEntry *find_class(const StringName &name) {
	for (const std::unique_ptr<ClassEntry> &entry : classes) {
		if (entry->name == name) {
			return entry.get();
		}
	}
	return nullptr;
}

GDExtensionClassCallVirtual find_virtual(
		void *userdata, GDExtensionConstStringNamePtr name, std::uint32_t hash) {
	const void *key = static_cast<const StringName *>(name)->identity();
	for (const auto *entry = static_cast<const ClassEntry *>(userdata); entry != nullptr;
			entry = entry->parent) {
		const auto found = entry->virtuals.find(key);
		if (found != entry->virtuals.end()) {
			return found->second.hash == hash ? found->second.function : nullptr;
		}
	}
	return nullptr;
}

} // namespace

void ClassDB::_set_level(GDExtensionInitializationLevel level) {
	current_level = level;
}

void ClassDB::begin_class(const StringName &name, const StringName &parent, const Flags &flags,
		GDExtensionClassCreationInfo5 &info) {
	auto entry = std::make_unique<ClassEntry>();
	entry->name = name;
	entry->parent = find_class(parent);
	entry->level = current_level;
	info.is_virtual = flags.is_virtual ? 1 : 0;
	info.is_abstract = flags.is_abstract ? 1 : 0;
	info.is_exposed = flags.is_exposed ? 1 : 0;
	info.is_runtime = flags.is_runtime ? 1 : 0;
	info.get_virtual_func = &find_virtual;
	info.class_userdata = entry.get();
	internal::api.classdb_register_extension_class5(
			internal::library, name._native_ptr(), parent._native_ptr(), &info);
	current = entry.get();
	classes.push_back(std::move(entry));
}

void ClassDB::end_class() {
	current = nullptr;
}

const StringName &ClassDB::current_class() {
	CRASH_COND_MSG(current == nullptr, "bind_method() belongs into _bind_methods().");
	return current->name;
}

MethodBind *ClassDB::add_method(const StringName &class_name, const MethodDefinition &definition,
		std::unique_ptr<MethodBind> method, std::vector<Variant> defaults) {
	ClassEntry *entry = find_class(class_name);
	ERR_FAIL_NULL_V_MSG(entry, nullptr,
			String("Method ") + String(definition.name) + " is bound to the unregistered class " +
					String(class_name) + ".");
	ERR_FAIL_COND_V_MSG(static_cast<int>(defaults.size()) > method->get_argument_count(), nullptr,
			String("Method ") + String(definition.name) + " has more default values than arguments.");
	method->_set_names(definition.name, definition.args);
	method->_set_defaults(std::move(defaults));
	method->_register(class_name);
	entry->methods.push_back(std::move(method));
	return entry->methods.back().get();
}

void ClassDB::_bind_virtual(const char *name, std::uint32_t hash, GDExtensionClassCallVirtual function) {
	VirtualMethod method{StringName(name), hash, function};
	const void *key = method.name.identity();
	current->virtuals.insert_or_assign(key, std::move(method));
}

void ClassDB::add_property(const StringName &class_name, const PropertyInfo &property,
		const StringName &setter, const StringName &getter, int index) {
	const GDExtensionPropertyInfo info = property._to_gdextension();
	internal::api.classdb_register_extension_class_property_indexed(internal::library,
			class_name._native_ptr(), &info, setter._native_ptr(), getter._native_ptr(), index);
}

void ClassDB::add_property_group(const StringName &class_name, const String &name, const String &prefix) {
	internal::api.classdb_register_extension_class_property_group(
			internal::library, class_name._native_ptr(), name._native_ptr(), prefix._native_ptr());
}

void ClassDB::add_property_subgroup(const StringName &class_name, const String &name, const String &prefix) {
	internal::api.classdb_register_extension_class_property_subgroup(
			internal::library, class_name._native_ptr(), name._native_ptr(), prefix._native_ptr());
}

void ClassDB::add_signal(const StringName &class_name, const MethodInfo &signal) {
	std::vector<GDExtensionPropertyInfo> arguments;
	for (const PropertyInfo &argument : signal.arguments) {
		arguments.push_back(argument._to_gdextension());
	}
	internal::api.classdb_register_extension_class_signal(internal::library, class_name._native_ptr(),
			signal.name._native_ptr(), arguments.data(), static_cast<GDExtensionInt>(arguments.size()));
}

void ClassDB::bind_integer_constant(const StringName &class_name, const StringName &enum_name,
		const StringName &name, std::int64_t value, bool is_bitfield) {
	internal::api.classdb_register_extension_class_integer_constant(internal::library,
			class_name._native_ptr(), enum_name._native_ptr(), name._native_ptr(), value,
			is_bitfield ? 1 : 0);
}

void ClassDB::_unregister_classes(GDExtensionInitializationLevel level) {
	while (!classes.empty() && classes.back()->level == level) {
		internal::api.classdb_unregister_extension_class(
				internal::library, classes.back()->name._native_ptr());
		classes.pop_back();
	}
}

} // namespace godot
