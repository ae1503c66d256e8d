# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/buffer_plan.cpp
	${CMAKE_CURRENT_LIST_DIR}/image_bound.cpp
	${CMAKE_CURRENT_LIST_DIR}/shift_bound.cpp
	${CMAKE_CURRENT_LIST_DIR}/star_groups.cpp
	${CMAKE_CURRENT_LIST_DIR}/star_rows.cpp)
