// SPDX-License-Identifier: MIT
// Entry of the test extension. It uses nothing but the public API of godot-cpp, so that it builds with either
// provider.
#include "probe_calls.h"
#include "probe_node.h"
#include "probe_resource.h"

#include <gdextension_interface.h>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

namespace {

void initialize(godot::ModuleInitializationLevel level) {
	if (level != godot::MODULE_INITIALIZATION_LEVEL_SCENE) {
		return;
	}
	GDREGISTER_CLASS(ProbeResource);
	GDREGISTER_CLASS(ProbeNode);
	GDREGISTER_CLASS(ProbeChildNode);
	GDREGISTER_CLASS(ProbeCalls);
	GDREGISTER_ABSTRACT_CLASS(ProbeShape);
	GDREGISTER_CLASS(ProbeCircle);
}

void terminate(godot::ModuleInitializationLevel /*level*/) {}

} // namespace

extern "C" GDExtensionBool GDE_EXPORT probe_init(GDExtensionInterfaceGetProcAddress get_proc_address,
		GDExtensionClassLibraryPtr library, GDExtensionInitialization *initialization) {
	const godot::GDExtensionBinding::InitObject init(get_proc_address, library, initialization);
	init.register_initializer(initialize);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(godot::MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
