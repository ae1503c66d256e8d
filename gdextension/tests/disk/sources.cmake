# SPDX-License-Identifier: MIT
blackhole_add_test(disk_test
	${CMAKE_CURRENT_SOURCE_DIR}/relativity/brute_force_geodesic.cpp
	${CMAKE_CURRENT_LIST_DIR}/disk_crossing_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/disk_point_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/integrated_sight.cpp
	${CMAKE_CURRENT_LIST_DIR}/page_thorne_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/plunging_gas_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/ray_radius_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/ray_tables_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/shader_disk_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/disk_temperature_test.cpp)
target_include_directories(disk_test PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(disk_test PRIVATE blackhole_lut_parts)
