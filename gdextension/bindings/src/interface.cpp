// SPDX-License-Identifier: MIT
#include "godot_provider/interface.hpp"

#include <cstdio>

namespace godot::internal {

Interface api;
GDExtensionClassLibraryPtr library = nullptr;

bool load_interface(GDExtensionInterfaceGetProcAddress get_proc_address, GDExtensionClassLibraryPtr handle) {
	library = handle;
	bool complete = true;
#define GODOT_PROVIDER_LOAD(type, name)                                                                      \
	api.name = reinterpret_cast<type>(reinterpret_cast<void *>(get_proc_address(#name)));                    \
	if (api.name == nullptr) {                                                                               \
		std::fprintf(                                                                                        \
				stderr, "This Godot lacks the extension function " #name "; use Godot 4.6 or newer.\n");     \
		complete = false;                                                                                    \
	}
	GODOT_PROVIDER_FUNCTIONS(GODOT_PROVIDER_LOAD)
#undef GODOT_PROVIDER_LOAD
	return complete;
}

} // namespace godot::internal
