// SPDX-License-Identifier: MIT
#include "godot_cpp/godot.hpp"

#include "godot_cpp/core/class_db.hpp"
#include "godot_provider/builtin.hpp"
#include "godot_provider/static_name.hpp"
#include "godot_provider/wrappers.hpp"

namespace godot {

namespace {

// One library has one entry function, so one set of callbacks.
struct Entry {
	GDExtensionBinding::Callback initializer = nullptr;
	GDExtensionBinding::Callback terminator = nullptr;
	GDExtensionInitializationLevel minimum_level = GDEXTENSION_INITIALIZATION_CORE;
};
Entry entry;

void initialize(void * /*userdata*/, GDExtensionInitializationLevel level) {
	if (level == entry.minimum_level) {
		internal::register_engine_classes();
	}
	ClassDB::_set_level(level);
	if (entry.initializer != nullptr) {
		entry.initializer(static_cast<ModuleInitializationLevel>(level));
	}
	if (level == GDEXTENSION_INITIALIZATION_EDITOR) {
		internal::DocDataRegistration::load_all();
	}
}

void deinitialize(void * /*userdata*/, GDExtensionInitializationLevel level) {
	if (entry.terminator != nullptr) {
		entry.terminator(static_cast<ModuleInitializationLevel>(level));
	}
	ClassDB::_unregister_classes(level);
	if (level == entry.minimum_level) {
		internal::release_all_wrappers();
		internal::StaticName::release_all();
	}
}

} // namespace

GDExtensionBinding::InitObject::InitObject(GDExtensionInterfaceGetProcAddress get_proc_address,
		GDExtensionClassLibraryPtr library, GDExtensionInitialization *initialization)
		: get_proc_address_(get_proc_address), library_(library), initialization_(initialization) {
	entry = {};
}

void GDExtensionBinding::InitObject::register_initializer(Callback callback) const {
	entry.initializer = callback;
}

void GDExtensionBinding::InitObject::register_terminator(Callback callback) const {
	entry.terminator = callback;
}

void GDExtensionBinding::InitObject::set_minimum_library_initialization_level(
		ModuleInitializationLevel level) const {
	entry.minimum_level = static_cast<GDExtensionInitializationLevel>(level);
}

GDExtensionBool GDExtensionBinding::InitObject::init() const {
	if (!internal::load_interface(get_proc_address_, library_)) {
		return 0;
	}
	internal::load_builtin_functions();
	initialization_->minimum_initialization_level = entry.minimum_level;
	initialization_->userdata = nullptr;
	initialization_->initialize = &initialize;
	initialization_->deinitialize = &deinitialize;
	return 1;
}

namespace internal {

namespace {

DocDataRegistration *first_document = nullptr;

} // namespace

DocDataRegistration::DocDataRegistration(const char *text, std::size_t size)
		: text_(text), size_(size), next_(std::exchange(first_document, this)) {}

void DocDataRegistration::load_all() {
	for (const DocDataRegistration *document = first_document; document != nullptr;
			document = document->next_) {
		api.editor_help_load_xml_from_utf8_chars_and_len(
				document->text_, static_cast<GDExtensionInt>(document->size_));
	}
}

} // namespace internal
} // namespace godot
