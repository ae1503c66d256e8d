# SPDX-License-Identifier: MIT
blackhole_add_test(test_hipparcos_catalogue ${CMAKE_CURRENT_LIST_DIR}/test_hipparcos_catalogue.cpp)
blackhole_add_test(test_star_file ${CMAKE_CURRENT_LIST_DIR}/test_star_file.cpp)
blackhole_add_test(test_star_csv ${CMAKE_CURRENT_LIST_DIR}/test_star_csv.cpp)
