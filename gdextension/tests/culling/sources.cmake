# SPDX-License-Identifier: MIT
blackhole_add_test(test_culling
	${CMAKE_CURRENT_LIST_DIR}/test_buffer_plan.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_image_bound.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_shift_bound.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_star_groups.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_star_rows.cpp)
