// SPDX-License-Identifier: MIT
#pragma once

namespace godot::internal {

// The qualified name of an enumeration known to the engine ("Class::Enum" or "Class.Enum"); null: unknown.
template <class T>
struct EnumName {
	static constexpr const char *kText = nullptr;
};

} // namespace godot::internal
