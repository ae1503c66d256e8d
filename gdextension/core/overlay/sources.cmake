# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/cube_map.cpp
	${CMAKE_CURRENT_LIST_DIR}/figure_field.cpp
	${CMAKE_CURRENT_LIST_DIR}/sky_segment.cpp)
