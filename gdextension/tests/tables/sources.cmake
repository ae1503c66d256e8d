# SPDX-License-Identifier: MIT
find_package(ZLIB REQUIRED)

blackhole_add_test(tables_test
	${CMAKE_CURRENT_LIST_DIR}/csv_table_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/eval_command_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/lensing_tables_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/shader_lensing_test.cpp
	${CMAKE_CURRENT_LIST_DIR}/table_file_test.cpp
)
target_link_libraries(tables_test PRIVATE blackhole_lut_parts ZLIB::ZLIB)

# The program itself: its exit status and the committed file.
set(_committed_table "${PROJECT_SOURCE_DIR}/../lut/schwarzschild.lut")
add_test(NAME blackhole_lut.version COMMAND blackhole-lut --version)
add_test(NAME blackhole_lut.committed_table_is_a_fresh_bake COMMAND blackhole-lut bake --check "${_committed_table}")
add_test(NAME blackhole_lut.committed_table_keeps_its_limits COMMAND blackhole-lut verify "${_committed_table}" --seed 7)
add_test(NAME blackhole_lut.refuses_a_file_that_is_no_table COMMAND blackhole-lut inspect "${CMAKE_CURRENT_LIST_FILE}")
add_test(NAME blackhole_lut.refuses_unknown_words COMMAND blackhole-lut frobnicate)
set_tests_properties(blackhole_lut.refuses_a_file_that_is_no_table blackhole_lut.refuses_unknown_words
	PROPERTIES WILL_FAIL TRUE)
set_tests_properties(blackhole_lut.version PROPERTIES PASS_REGULAR_EXPRESSION "blackhole-lut ${PROJECT_VERSION}")
