# SPDX-License-Identifier: MIT
blackhole_add_test(relativity_test
	${CMAKE_CURRENT_LIST_DIR}/brute_force_fall.cpp
	${CMAKE_CURRENT_LIST_DIR}/brute_force_geodesic.cpp
	${CMAKE_CURRENT_LIST_DIR}/circular_orbit_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/clocks_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/deflection_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/image_direction_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/observer_field_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/observer_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/orbital_angle_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/radial_fall_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/radial_path_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/reference_columns_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/star_image_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/world_line_test.cpp
)
target_include_directories(relativity_test PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(relativity_test PRIVATE blackhole_lut_parts)
