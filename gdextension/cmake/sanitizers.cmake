# SPDX-License-Identifier: MIT
# use_sanitizers("address,undefined"): every target from here on is built with these sanitizers.
function(use_sanitizers names)
	add_compile_options(-fsanitize=${names} -fno-omit-frame-pointer -g)
	add_link_options(-fsanitize=${names})
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
