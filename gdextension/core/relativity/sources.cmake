# SPDX-License-Identifier: MIT
target_sources(blackhole_core PRIVATE
	${CMAKE_CURRENT_LIST_DIR}/circular_orbit.cpp
	${CMAKE_CURRENT_LIST_DIR}/clocks.cpp
	${CMAKE_CURRENT_LIST_DIR}/deflection.cpp
	${CMAKE_CURRENT_LIST_DIR}/einstein_ring.cpp
	${CMAKE_CURRENT_LIST_DIR}/image_direction.cpp
	${CMAKE_CURRENT_LIST_DIR}/magnification.cpp
	${CMAKE_CURRENT_LIST_DIR}/observer.cpp
	${CMAKE_CURRENT_LIST_DIR}/observer_field.cpp
	${CMAKE_CURRENT_LIST_DIR}/orbital_angle.cpp
	${CMAKE_CURRENT_LIST_DIR}/physical_scale.cpp
	${CMAKE_CURRENT_LIST_DIR}/radial_fall.cpp
	${CMAKE_CURRENT_LIST_DIR}/radial_path.cpp
	${CMAKE_CURRENT_LIST_DIR}/redshift.cpp
	${CMAKE_CURRENT_LIST_DIR}/shadow.cpp
	${CMAKE_CURRENT_LIST_DIR}/sky_frame.cpp
	${CMAKE_CURRENT_LIST_DIR}/star_image.cpp
	${CMAKE_CURRENT_LIST_DIR}/view_angle.cpp
	${CMAKE_CURRENT_LIST_DIR}/world_line.cpp
)
