// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/utility_functions.hpp"

namespace godot {

template <class... Values>
void print_line(const Values &...values) {
	UtilityFunctions::print(values...);
}
template <class... Values>
void print_error(const Values &...values) {
	UtilityFunctions::printerr(values...);
}

} // namespace godot
