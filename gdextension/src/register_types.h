// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/godot.hpp>

void initialize_blackhole_sky(godot::ModuleInitializationLevel level);
void uninitialize_blackhole_sky(godot::ModuleInitializationLevel level);
