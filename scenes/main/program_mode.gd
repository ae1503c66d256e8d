# SPDX-License-Identifier: MIT
class_name ProgramMode
extends RefCounted
## What the program is started as, by its own arguments (CommandLine).

enum Kind { DESKTOP, HEADSET, KIOSK, SUPERVISOR, SELF_TEST }

## Alone, or with `=FILE.json`.
const SELF_TEST_ARGUMENT: String = "--self-test"
const HEADSET_ARGUMENT: String = "--headset"
const KIOSK_ARGUMENT: String = "--kiosk"
const SUPERVISOR_ARGUMENT: String = "--supervise"
const SCENES: Dictionary[Kind, String] = {
	Kind.DESKTOP: "res://scenes/desktop/desktop.tscn",
	Kind.HEADSET: "res://scenes/xr/xr.tscn",
	Kind.KIOSK: "res://scenes/kiosk/kiosk.tscn",
	Kind.SUPERVISOR: "res://scenes/kiosk/supervisor/supervisor.tscn",
	Kind.SELF_TEST: "res://scenes/self_test/self_test.tscn",
}


## The kind that a command line asks for; with a headset ready and nothing asked for, the headset.
static func of(arguments: PackedStringArray, headset_ready: bool) -> Kind:
	for argument in arguments:
		if argument == SELF_TEST_ARGUMENT or argument.begins_with(SELF_TEST_ARGUMENT + "="):
			return Kind.SELF_TEST
	if arguments.has(SUPERVISOR_ARGUMENT):
		return Kind.SUPERVISOR
	if arguments.has(KIOSK_ARGUMENT):
		return Kind.KIOSK
	if arguments.has(HEADSET_ARGUMENT) or headset_ready:
		return Kind.HEADSET
	return Kind.DESKTOP
