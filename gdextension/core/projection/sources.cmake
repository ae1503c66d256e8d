# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/sky_map.cpp
)
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/sky_map.cpp PROPERTIES OBJECT_DEPENDS "${_shader_sources}")
