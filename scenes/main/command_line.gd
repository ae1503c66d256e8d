# SPDX-License-Identifier: MIT
class_name CommandLine
extends RefCounted
## The program's own arguments: those after `--`, and its own words among those before it.

## Words of the program that need no `--` before them: the engine lets alone what it does not know.
const WORDS: PackedStringArray = [
	"--self-test", "--headset", "--kiosk", "--kiosk-config", "--supervise"
]


## What this program was started with.
static func of_program() -> PackedStringArray:
	return own(OS.get_cmdline_args(), OS.get_cmdline_user_args())


## The program's own arguments out of those before `--` (`engine`) and after it (`user`).
static func own(engine: PackedStringArray, user: PackedStringArray) -> PackedStringArray:
	var all: PackedStringArray = []
	for argument in engine:
		if WORDS.has(argument.get_slice("=", 0)):
			all.append(argument)
	all.append_array(user)
	return all


## What follows `beginning`, such as "--seed=", in the first argument that begins so; empty when
## none does.
static func value(arguments: PackedStringArray, beginning: String) -> String:
	for argument in arguments:
		if argument.begins_with(beginning):
			return argument.trim_prefix(beginning)
	return ""
