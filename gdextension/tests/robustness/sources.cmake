# SPDX-License-Identifier: MIT
# Counts what is allocated, so it replaces operator new: an executable of its own.
blackhole_add_test(test_hostile_files
	${CMAKE_CURRENT_LIST_DIR}/allocation_meter.cpp
	${CMAKE_CURRENT_LIST_DIR}/sparse_file.cpp
	${CMAKE_CURRENT_LIST_DIR}/test_hostile_files.cpp)
target_link_libraries(test_hostile_files PRIVATE blackhole_lut_parts)

# What works on several threads; the preset tsan runs it under the thread sanitizer.
blackhole_add_test(test_threads
	${CMAKE_CURRENT_LIST_DIR}/test_threads.cpp)
