# SPDX-License-Identifier: MIT
# Defines godot::cpp, the C++ face of the engine: upstream godot-cpp when its folder is given or present,
# otherwise the small provider in bindings/ generated from the engine's own API dump.
if(NOT GODOT_CPP_DIR AND EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/godot-cpp/CMakeLists.txt")
	set(GODOT_CPP_DIR "${CMAKE_CURRENT_SOURCE_DIR}/godot-cpp")
endif()

if(GODOT_CPP_DIR)
	message(STATUS "Bindings: upstream godot-cpp in ${GODOT_CPP_DIR}")
	# The API of the engine in use, as with our own provider; upstream's headers are not held to our warnings.
	include(bindings/cmake/engine_api.cmake)
	godot_dump_api("${CMAKE_BINARY_DIR}/api")
	set(GODOTCPP_CUSTOM_API_FILE "${CMAKE_BINARY_DIR}/api/extension_api.json" CACHE FILEPATH "Extension API")
	set(GODOTCPP_SYSTEM_HEADERS ON CACHE BOOL "Treat upstream's headers as the system's")
	find_package(Python3 REQUIRED COMPONENTS Interpreter) # target_doc_sources looks for it here
	add_subdirectory("${GODOT_CPP_DIR}" "${CMAKE_BINARY_DIR}/godot-cpp" EXCLUDE_FROM_ALL)
else()
	message(STATUS "Bindings: the built-in provider")
	add_subdirectory(bindings)
endif()
