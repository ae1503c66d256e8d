// SPDX-License-Identifier: MIT
#pragma once

#include "godot_provider/generated/callable_methods.hpp"

namespace godot {

class Object;
class StringName;

// A method bound to its object.
class Callable : public internal::CallableMethods {
public:
	Callable() = default;
	Callable(const Object *object, const StringName &method);
	// Takes over a callable that the engine has just made (callable_method_pointer.hpp).
	explicit Callable(GDExtensionCallableCustomInfo2 &info);

	bool operator==(const Callable &other) const;
	bool operator!=(const Callable &other) const { return !(*this == other); }
};

} // namespace godot
