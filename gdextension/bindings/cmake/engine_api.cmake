# SPDX-License-Identifier: MIT
# Brings extension_api.json and gdextension_interface.h of the engine in use into the build tree.

# Finds the engine: -DGODOT_EXECUTABLE, -DGODOT, the environment's GODOT, then godot4 or godot on PATH.
function(godot_find_executable result)
	if(GODOT_EXECUTABLE)
		set(found "${GODOT_EXECUTABLE}")
	elseif(GODOT)
		set(found "${GODOT}")
	elseif(DEFINED ENV{GODOT})
		set(found "$ENV{GODOT}")
	else()
		find_program(found_on_path NAMES godot4 godot NO_CACHE)
		set(found "${found_on_path}")
	endif()
	if(NOT found)
		message(FATAL_ERROR "No Godot found to take the extension API from. Install Godot 4.6 or newer, or pass "
			"-DGODOT_EXECUTABLE=/path/to/godot; or give upstream bindings with -DGODOT_CPP_DIR=/path/to/godot-cpp.")
	endif()
	set(GODOT_EXECUTABLE "${found}" CACHE FILEPATH "Godot 4.6 or newer, source of the extension API" FORCE)
	set(${result} "${found}" PARENT_SCOPE)
endfunction()

# Dumps the API into folder, unless it is there already for this version of the engine.
function(godot_dump_api folder)
	godot_find_executable(godot)
	execute_process(COMMAND "${godot}" --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE
		ERROR_QUIET RESULT_VARIABLE status)
	if(NOT status EQUAL 0)
		message(FATAL_ERROR "\"${godot} --version\" failed (${status}): set GODOT_EXECUTABLE to a working Godot.")
	endif()
	if(NOT version MATCHES "^([0-9]+\\.[0-9]+)" OR CMAKE_MATCH_1 VERSION_LESS 4.6)
		message(FATAL_ERROR "${godot} is version ${version}; the extension needs Godot 4.6 or newer.")
	endif()

	set(stamp "${folder}/version.txt")
	if(EXISTS "${stamp}" AND EXISTS "${folder}/extension_api.json" AND EXISTS "${folder}/gdextension_interface.h")
		file(READ "${stamp}" dumped)
		if(dumped STREQUAL version)
			return()
		endif()
	endif()
	message(STATUS "Reading the extension API of Godot ${version}")
	file(REMOVE "${stamp}")
	file(MAKE_DIRECTORY "${folder}")
	execute_process(COMMAND "${godot}" --headless --dump-extension-api --dump-gdextension-interface
		WORKING_DIRECTORY "${folder}" OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
	if(NOT EXISTS "${folder}/extension_api.json" OR NOT EXISTS "${folder}/gdextension_interface.h")
		message(FATAL_ERROR "\"${godot} --dump-extension-api --dump-gdextension-interface\" wrote nothing "
			"(${status}); use an editor build of Godot.\n${output}")
	endif()
	file(WRITE "${stamp}" "${version}")
endfunction()
