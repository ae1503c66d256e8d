# SPDX-License-Identifier: MIT
# GLM and Boost are headers alone, the same for every machine. A compiler for another one must not see the folder of
# this machine's headers in which they lie: it gets a folder with links to the two.
set(_headers "${CMAKE_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${_headers}")
foreach(_library glm/glm.hpp boost/version.hpp)
	get_filename_component(_name "${_library}" DIRECTORY)
	find_path(HEADERS_OF_${_name} "${_library}" PATHS /usr/include /usr/local/include /opt/homebrew/include
		NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
	if(NOT HEADERS_OF_${_name})
		message(FATAL_ERROR "The headers ${_library} were not found. Give their folder with -DHEADERS_OF_${_name}=...")
	endif()
	file(CREATE_LINK "${HEADERS_OF_${_name}}/${_name}" "${_headers}/${_name}" SYMBOLIC)
endforeach()
add_library(glm::glm INTERFACE IMPORTED)
target_include_directories(glm::glm SYSTEM INTERFACE "${_headers}")
set(Boost_INCLUDE_DIRS "${_headers}")
