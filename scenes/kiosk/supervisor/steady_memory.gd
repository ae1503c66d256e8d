# SPDX-License-Identifier: MIT
class_name SteadyMemory
extends RefCounted
## How the program that is started shall ask for memory, so that it holds as much after months as
## after the first visits.
##
## The C library of Linux takes large pieces for themselves, but raises what it calls large to the
## size of any that is given back. From then on textures and scenes of tens of megabytes lie between
## small pieces that outlive them, and the program keeps the gaps. It also keeps a heap for each
## thread, and each remembers the most that was ever needed in it, as when the graphics driver
## compiles a shader: some tens of megabytes, once for every thread that happens to be the one. So
## the limits are set, and the gaps of one heap serve all threads.

## What the C library reads (mallopt(3)): bytes, and a number of heaps.
const VARIABLES: Dictionary[String, String] = {
	"MALLOC_MMAP_THRESHOLD_": "262144",
	"MALLOC_TRIM_THRESHOLD_": "1048576",
	"MALLOC_ARENA_MAX": "1",
}


## For programs started from now on; what the operator has set is kept.
static func prepare() -> void:
	if not OS.has_feature("linux"):
		return
	for variable: String in VARIABLES:
		if not OS.has_environment(variable):
			OS.set_environment(variable, VARIABLES[variable])
