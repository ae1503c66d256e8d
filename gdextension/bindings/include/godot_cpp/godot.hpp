// SPDX-License-Identifier: MIT
// The library's entry: what the init function of an extension uses.
#pragma once

#include "godot_provider/interface.hpp"

#include <cstddef>

namespace godot {

enum ModuleInitializationLevel {
	MODULE_INITIALIZATION_LEVEL_CORE = GDEXTENSION_INITIALIZATION_CORE,
	MODULE_INITIALIZATION_LEVEL_SERVERS = GDEXTENSION_INITIALIZATION_SERVERS,
	MODULE_INITIALIZATION_LEVEL_SCENE = GDEXTENSION_INITIALIZATION_SCENE,
	MODULE_INITIALIZATION_LEVEL_EDITOR = GDEXTENSION_INITIALIZATION_EDITOR,
	MODULE_INITIALIZATION_LEVEL_MAX
};

class GDExtensionBinding {
public:
	using Callback = void (*)(ModuleInitializationLevel level);

	// Collects what the extension wants done at each level, then hands it to the engine.
	class InitObject {
	public:
		InitObject(GDExtensionInterfaceGetProcAddress get_proc_address, GDExtensionClassLibraryPtr library,
				GDExtensionInitialization *initialization);

		void register_initializer(Callback callback) const;
		void register_terminator(Callback callback) const;
		void set_minimum_library_initialization_level(ModuleInitializationLevel level) const;

		// 1 when the engine offers all that the bindings need.
		GDExtensionBool init() const;

	private:
		GDExtensionInterfaceGetProcAddress get_proc_address_;
		GDExtensionClassLibraryPtr library_;
		GDExtensionInitialization *initialization_;
	};
};

namespace internal {

// One class description (XML) compiled into the library, shown by the editor's help.
class DocDataRegistration {
public:
	DocDataRegistration(const char *text, std::size_t size);

	// Hands every description to the editor.
	static void load_all();

private:
	const char *text_;
	std::size_t size_;
	DocDataRegistration *next_;
};

} // namespace internal
} // namespace godot
