// SPDX-License-Identifier: MIT
#pragma once

#include "godot_provider/generated/node_path_methods.hpp"

namespace godot {

class String;

// A path in the scene tree.
class NodePath : public internal::NodePathMethods {
public:
	NodePath() = default;
	NodePath(const char *text);
	NodePath(const String &text);

	bool operator==(const NodePath &other) const;
	bool operator!=(const NodePath &other) const { return !(*this == other); }
};

} // namespace godot
