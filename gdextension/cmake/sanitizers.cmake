# SPDX-License-Identifier: MIT
# use_sanitizers("address,undefined"): every target from here on is built with these sanitizers.
function(use_sanitizers names)
	add_compile_options(-fsanitize=${names} -fno-omit-frame-pointer -g)
	add_link_options(-fsanitize=${names})
	# What undefined behaviour is found ends the program: a line in a log that nobody reads is no finding.
	if(names MATCHES "undefined")
		add_compile_options(-fno-sanitize-recover=all)
	endif()
	# Upstream godot-cpp refuses to be compiled with a sanitizer that it is not told of.
	set(macro_address ASAN_ENABLED)
	set(macro_undefined UBSAN_ENABLED)
	set(macro_thread TSAN_ENABLED)
	set(macro_leak LSAN_ENABLED)
	set(macro_memory MSAN_ENABLED)
	string(REPLACE "," ";" names "${names}")
	foreach(name IN LISTS names)
		if(macro_${name})
			add_compile_definitions(${macro_${name}})
		endif()
	endforeach()
endfunction()
