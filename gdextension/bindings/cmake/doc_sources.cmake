# SPDX-License-Identifier: MIT
# target_doc_sources(TARGET XML...): compiles class descriptions into an extension, as upstream's function of
# the same name does, so that the editor's help shows them.
function(target_doc_sources target sources)
	set(out "${CMAKE_CURRENT_BINARY_DIR}/gen/doc_source.cpp")
	set(documents ${sources} ${ARGN})
	list(TRANSFORM documents REPLACE "^([^/].*)$" "${CMAKE_CURRENT_SOURCE_DIR}/\\1")
	get_property(bindings GLOBAL PROPERTY GODOT_PROVIDER_DIR)
	find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
	add_custom_command(
		OUTPUT "${out}"
		COMMAND "${Python3_EXECUTABLE}" -m generator.docs "${out}" ${documents}
		WORKING_DIRECTORY "${bindings}"
		DEPENDS ${documents} "${bindings}/generator/docs.py"
		COMMENT "Collecting class descriptions"
		VERBATIM)
	target_sources(${target} PRIVATE "${out}")
endfunction()
