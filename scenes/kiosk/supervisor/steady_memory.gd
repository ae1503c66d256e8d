# SPDX-License-Identifier: MIT
class_name SteadyMemory
extends RefCounted
## How the program that is started shall ask for memory, so that it holds as much after months as
## after the first visits.
##
## The C library of Linux takes large pieces for themselves, but raises what it calls large to the
## size of any that is given back. From then on textures and scenes of tens of megabytes lie between
## small pieces that outlive them, and the program keeps the gaps: it grows by a step whenever none
## of them happens to fit. With a limit that is set it does not raise it.

## What the C library reads, and pieces of so many bytes (mallopt(3)).
const VARIABLES: Dictionary[String, String] = {
	"MALLOC_MMAP_THRESHOLD_": "262144",
	"MALLOC_TRIM_THRESHOLD_": "1048576",
}


## For programs started from now on; what the operator has set is kept.
static func prepare() -> void:
	if not OS.has_feature("linux"):
		return
	for variable: String in VARIABLES:
		if not OS.has_environment(variable):
			OS.set_environment(variable, VARIABLES[variable])
