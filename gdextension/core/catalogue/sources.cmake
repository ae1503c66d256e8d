# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/csv_records.cpp
	${CMAKE_CURRENT_LIST_DIR}/plain_text.cpp
	${CMAKE_CURRENT_LIST_DIR}/star.cpp
	${CMAKE_CURRENT_LIST_DIR}/star_csv.cpp
	${CMAKE_CURRENT_LIST_DIR}/star_file.cpp)
