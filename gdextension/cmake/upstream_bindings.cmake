# SPDX-License-Identifier: MIT
# Defines godot::cpp from the upstream godot-cpp in GODOT_CPP_DIR, for the API of the engine in use.
# Upstream has no default API version, and its headers are not held to our warnings.
include("${CMAKE_CURRENT_LIST_DIR}/../bindings/cmake/engine_api.cmake")
godot_dump_api("${CMAKE_BINARY_DIR}/api")
set(GODOTCPP_CUSTOM_API_FILE "${CMAKE_BINARY_DIR}/api/extension_api.json" CACHE FILEPATH "Extension API")
set(GODOTCPP_SYSTEM_HEADERS ON CACHE BOOL "Treat upstream's headers as the system's")
find_package(Python3 REQUIRED COMPONENTS Interpreter) # target_doc_sources looks for it here
add_subdirectory("${GODOT_CPP_DIR}" "${CMAKE_BINARY_DIR}/godot-cpp" EXCLUDE_FROM_ALL)
