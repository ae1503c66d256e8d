# SPDX-License-Identifier: MIT
find_package(nlohmann_json 3.9 REQUIRED)
blackhole_add_test(test_overlay
	${CMAKE_CURRENT_LIST_DIR}/cube_sampler.cpp
	${CMAKE_CURRENT_LIST_DIR}/shipped_figures.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_cube_map.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_figure_field.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_shipped_figure_field.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_sky_segment.cpp)
target_link_libraries(test_overlay PRIVATE nlohmann_json::nlohmann_json)
