# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/lensing_shader.cpp
	${CMAKE_CURRENT_LIST_DIR}/lensing_tables.cpp
	${CMAKE_CURRENT_LIST_DIR}/ray_tables.cpp
	${CMAKE_CURRENT_LIST_DIR}/ray_texels.cpp
	${CMAKE_CURRENT_LIST_DIR}/shader_disk.cpp
	${CMAKE_CURRENT_LIST_DIR}/shader_lensing.cpp
	${CMAKE_CURRENT_LIST_DIR}/table_file.cpp
)

# lensing_shader.cpp includes the shaders' sources with their literals marked as single precision.
set(_shader_to_cpp "${CMAKE_CURRENT_LIST_DIR}/shader_to_cpp.cmake")
set(_shader_sources)
foreach(_name observer lensing effects ray_tables disk_crossing disk_delay disk_gas map_projection)
	set(_shader "${PROJECT_SOURCE_DIR}/../addons/blackhole_sky/shaders/${_name}.gdshaderinc")
	set(_source "${CMAKE_CURRENT_BINARY_DIR}/shader_source/${_name}_source.inc")
	add_custom_command(OUTPUT "${_source}"
		COMMAND ${CMAKE_COMMAND} -DINPUT=${_shader} -DOUTPUT=${_source} -P "${_shader_to_cpp}"
		DEPENDS "${_shader}" "${_shader_to_cpp}" VERBATIM)
	list(APPEND _shader_sources "${_source}")
endforeach()
target_sources(blackhole_core PRIVATE ${_shader_sources})
target_include_directories(blackhole_core PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/shader_source")
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/lensing_shader.cpp PROPERTIES
	OBJECT_DEPENDS "${_shader_sources}" SKIP_UNITY_BUILD_INCLUSION ON)

# The addon reads the committed table from its own folder.
set(_addon_table "${PROJECT_SOURCE_DIR}/../addons/blackhole_sky/data/schwarzschild.lut")
set(_committed_table "${PROJECT_SOURCE_DIR}/../lut/schwarzschild.lut")
add_custom_command(OUTPUT "${_addon_table}"
	COMMAND ${CMAKE_COMMAND} -E copy "${_committed_table}" "${_addon_table}"
	DEPENDS "${_committed_table}" COMMENT "Copying the lensing table into the addon" VERBATIM)
add_custom_target(blackhole_addon_table ALL DEPENDS "${_addon_table}")
