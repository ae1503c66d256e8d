// SPDX-License-Identifier: MIT
#pragma once

#include "godot_provider/generated/rid_methods.hpp"

namespace godot {

// A handle of one of the engine's servers.
class RID : public internal::RIDMethods {
public:
	bool operator==(const RID &other) const { return get_id() == other.get_id(); }
	bool operator!=(const RID &other) const { return get_id() != other.get_id(); }
	bool operator<(const RID &other) const { return get_id() < other.get_id(); }
};

} // namespace godot
