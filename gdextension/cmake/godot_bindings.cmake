# SPDX-License-Identifier: MIT
# Defines godot::cpp, the C++ face of the engine: upstream godot-cpp when its folder is given or present,
# otherwise the small provider in bindings/ generated from the engine's own API dump.
if(NOT GODOT_CPP_DIR AND EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/godot-cpp/CMakeLists.txt")
	set(GODOT_CPP_DIR "${CMAKE_CURRENT_SOURCE_DIR}/godot-cpp")
endif()

if(GODOT_CPP_DIR)
	message(STATUS "Bindings: upstream godot-cpp in ${GODOT_CPP_DIR}")
	include("${CMAKE_CURRENT_LIST_DIR}/upstream_bindings.cmake")
else()
	message(STATUS "Bindings: the built-in provider")
	add_subdirectory(bindings)
endif()
