# SPDX-License-Identifier: MIT
blackhole_add_test(test_projection
	${CMAKE_CURRENT_LIST_DIR}/test_sky_map.cpp)
