# SPDX-License-Identifier: MIT
class_name CommandLine
extends RefCounted
## Reads the program's own arguments, those after `--`.


## What follows `beginning`, such as "--seed=", in the first argument that begins so; empty when
## none does.
static func value(arguments: PackedStringArray, beginning: String) -> String:
	for argument in arguments:
		if argument.begins_with(beginning):
			return argument.trim_prefix(beginning)
	return ""
