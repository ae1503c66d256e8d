// SPDX-License-Identifier: MIT
// The C++ objects that stand for the engine's objects, and how they come into being.
//
// An engine object that our code meets gets one wrapper of the nearest listed class, made on first use, kept
// with the engine object and deleted with it. An object of one of our own classes is its own wrapper.
#pragma once

#include "godot_provider/interface.hpp"

#include <cstddef>

namespace godot {

class StringName;
class Wrapped;

namespace internal {

// What the constructor of Wrapped is to do next on this thread; consumed by it.
struct ConstructionOrder {
	const StringName *engine_class = nullptr; // make an engine object of this class ...
	const StringName *extension_class =
			nullptr;                         // ... and make it an instance of ours (null: plain engine class)
	GDExtensionObjectPtr existing = nullptr; // or stand for this object
	const GDExtensionInstanceBindingCallbacks *callbacks =
			nullptr; // register as its wrapper (null: the engine does)
	bool pending = false;
};
ConstructionOrder &construction_order();

// The wrapper of an engine object; null for null.
Wrapped *wrapper_of(GDExtensionObjectPtr object);

// Records how objects of a listed engine class are wrapped.
void register_engine_class(const StringName &name, const GDExtensionInstanceBindingCallbacks *callbacks);

// Sends NOTIFICATION_POSTINITIALIZE, which the engine leaves to whoever constructs.
void send_postinitialize(Wrapped &object);

// Hands every engine object still wrapped its freedom, so that none calls into an unloaded library.
void release_all_wrappers();

// Number of wrappers of engine objects alive now (tests).
std::size_t live_wrapper_count();

// Registers every listed engine class (generated).
void register_engine_classes();

} // namespace internal
} // namespace godot
