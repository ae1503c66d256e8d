# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/disk_crossing.cpp
	${CMAKE_CURRENT_LIST_DIR}/disk_glow.cpp
	${CMAKE_CURRENT_LIST_DIR}/disk_point.cpp
	${CMAKE_CURRENT_LIST_DIR}/page_thorne.cpp
	${CMAKE_CURRENT_LIST_DIR}/plunging_gas.cpp
	${CMAKE_CURRENT_LIST_DIR}/ray_radius.cpp)
