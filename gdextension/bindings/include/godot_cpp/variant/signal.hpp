// SPDX-License-Identifier: MIT
#pragma once

#include "godot_provider/generated/signal_methods.hpp"

namespace godot {

class Object;
class StringName;

// A signal bound to its object.
class Signal : public internal::SignalMethods {
public:
	Signal() = default;
	Signal(const Object *object, const StringName &signal);
};

} // namespace godot
