# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/adaptation.cpp
	${CMAKE_CURRENT_LIST_DIR}/cie1931.cpp
	${CMAKE_CURRENT_LIST_DIR}/colour_index.cpp
	${CMAKE_CURRENT_LIST_DIR}/light_meter.cpp
	${CMAKE_CURRENT_LIST_DIR}/pixel_blur.cpp
	${CMAKE_CURRENT_LIST_DIR}/planck.cpp
	${CMAKE_CURRENT_LIST_DIR}/planck_table.cpp
	${CMAKE_CURRENT_LIST_DIR}/point_spread.cpp
	${CMAKE_CURRENT_LIST_DIR}/point_spread_table.cpp
	${CMAKE_CURRENT_LIST_DIR}/radiometry.cpp
	${CMAKE_CURRENT_LIST_DIR}/sky_brightness.cpp)
