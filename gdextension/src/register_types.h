// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/class_db.hpp>

void initialize_blackhole_sky(godot::ModuleInitializationLevel level);
void uninitialize_blackhole_sky(godot::ModuleInitializationLevel level);
