# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/lensing_shader.cpp
	${CMAKE_CURRENT_LIST_DIR}/lensing_tables.cpp
	${CMAKE_CURRENT_LIST_DIR}/shader_lensing.cpp
	${CMAKE_CURRENT_LIST_DIR}/table_file.cpp
)

# The shader source that lensing_shader.cpp includes knows float literals only.
set(_lensing_shader "${PROJECT_SOURCE_DIR}/../addons/blackhole_sky/shaders/lensing.gdshaderinc")
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
	set(_single_precision "SHELL:-Xclang -cl-single-precision-constant")
else()
	set(_single_precision "-fsingle-precision-constant")
endif()
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/lensing_shader.cpp PROPERTIES
	COMPILE_OPTIONS "${_single_precision}" OBJECT_DEPENDS "${_lensing_shader}")

# The addon reads the committed table from its own folder.
set(_addon_table "${PROJECT_SOURCE_DIR}/../addons/blackhole_sky/data/schwarzschild.lut")
set(_committed_table "${PROJECT_SOURCE_DIR}/../lut/schwarzschild.lut")
add_custom_command(OUTPUT "${_addon_table}"
	COMMAND ${CMAKE_COMMAND} -E copy "${_committed_table}" "${_addon_table}"
	DEPENDS "${_committed_table}" COMMENT "Copying the lensing table into the addon" VERBATIM)
add_custom_target(blackhole_addon_table ALL DEPENDS "${_addon_table}")
