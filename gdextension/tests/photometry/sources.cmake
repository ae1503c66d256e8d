# SPDX-License-Identifier: MIT
blackhole_add_test(test_planck ${CMAKE_CURRENT_LIST_DIR}/test_planck.cpp)
blackhole_add_test(test_colour_index ${CMAKE_CURRENT_LIST_DIR}/test_colour_index.cpp)
blackhole_add_test(test_radiometry ${CMAKE_CURRENT_LIST_DIR}/test_radiometry.cpp)
blackhole_add_test(test_exposure
	${CMAKE_CURRENT_LIST_DIR}/test_adaptation.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_light_meter.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_sky_brightness.cpp)
blackhole_add_test(test_planck_table
	${CMAKE_CURRENT_LIST_DIR}/test_planck_table.cpp
	${CMAKE_CURRENT_LIST_DIR}/planck_shader.cpp)
blackhole_add_test(test_point_spread ${CMAKE_CURRENT_LIST_DIR}/test_point_spread.cpp)
blackhole_add_test(test_point_spread_table
	${CMAKE_CURRENT_LIST_DIR}/test_point_spread_table.cpp
	${CMAKE_CURRENT_LIST_DIR}/profile_shader.cpp)
# The shaders' literals are single precision, as on the GPU.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
	set_source_files_properties(
		${CMAKE_CURRENT_LIST_DIR}/planck_shader.cpp ${CMAKE_CURRENT_LIST_DIR}/profile_shader.cpp
		PROPERTIES COMPILE_OPTIONS "-fsingle-precision-constant" SKIP_PRECOMPILE_HEADERS ON)
endif()
