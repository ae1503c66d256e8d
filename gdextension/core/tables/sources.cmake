# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/lensing_shader.cpp
	${CMAKE_CURRENT_LIST_DIR}/lensing_tables.cpp
	${CMAKE_CURRENT_LIST_DIR}/shader_lensing.cpp
	${CMAKE_CURRENT_LIST_DIR}/table_file.cpp
)

# lensing_shader.cpp includes the shader's source with its literals marked as single precision.
set(_lensing_shader "${PROJECT_SOURCE_DIR}/../addons/blackhole_sky/shaders/lensing.gdshaderinc")
set(_lensing_include "${CMAKE_CURRENT_BINARY_DIR}/shader_source/lensing_shader_source.inc")
set(_shader_to_cpp "${CMAKE_CURRENT_LIST_DIR}/shader_to_cpp.cmake")
add_custom_command(OUTPUT "${_lensing_include}"
	COMMAND ${CMAKE_COMMAND} -DINPUT=${_lensing_shader} -DOUTPUT=${_lensing_include} -P "${_shader_to_cpp}"
	DEPENDS "${_lensing_shader}" "${_shader_to_cpp}" VERBATIM)
target_sources(blackhole_core PRIVATE "${_lensing_include}")
target_include_directories(blackhole_core PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/shader_source")
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/lensing_shader.cpp PROPERTIES OBJECT_DEPENDS "${_lensing_include}")

# The addon reads the committed table from its own folder.
set(_addon_table "${PROJECT_SOURCE_DIR}/../addons/blackhole_sky/data/schwarzschild.lut")
set(_committed_table "${PROJECT_SOURCE_DIR}/../lut/schwarzschild.lut")
add_custom_command(OUTPUT "${_addon_table}"
	COMMAND ${CMAKE_COMMAND} -E copy "${_committed_table}" "${_addon_table}"
	DEPENDS "${_committed_table}" COMMENT "Copying the lensing table into the addon" VERBATIM)
add_custom_target(blackhole_addon_table ALL DEPENDS "${_addon_table}")
