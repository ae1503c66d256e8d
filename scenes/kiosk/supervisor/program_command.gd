# SPDX-License-Identifier: MIT
class_name ProgramCommand
extends RefCounted
## How the supervisor starts the exhibit: the same program, with its own command line less what
## concerns the supervisor.

const SCENE: String = ProgramMode.SCENES[ProgramMode.Kind.KIOSK]
## On the command line, after --: an argument for the engine of the program that is started.
const ENGINE: String = "--engine="
## Not handed on as they are.
const OWN: PackedStringArray = [ProgramMode.SUPERVISOR_ARGUMENT, ProgramMode.KIOSK_ARGUMENT]
const XR_MODE: String = "--xr-mode"


## The arguments; `user` are those after --, `project` is the project's folder while the project
## runs in the engine, empty in an exported program; `headset`: a runtime is looked for.
static func arguments(user: PackedStringArray, project: String, headset: bool) -> PackedStringArray:
	var engine: PackedStringArray = []
	var handed: PackedStringArray = [ProgramMode.KIOSK_ARGUMENT]
	for argument in user:
		if argument.begins_with(ENGINE):
			engine.append(argument.trim_prefix(ENGINE))
		elif not OWN.has(argument):
			handed.append(argument)
	if headset and not engine.has(XR_MODE):
		engine.append_array([XR_MODE, "on"])
	var all: PackedStringArray = []
	if not project.is_empty():
		all.append_array(["--path", project])
	all.append_array(engine)
	if not project.is_empty():
		all.append(SCENE)
	all.append("--")
	all.append_array(handed)
	return all


## The same for this program.
static func of_program(config: KioskConfig) -> PackedStringArray:
	var project := ""
	if OS.has_feature("editor"):
		project = ProjectSettings.globalize_path("res://").trim_suffix("/")
	var all := arguments(CommandLine.of_program(), project, config.text("mode") != "screen")
	all.append(SupervisorWatch.argument())
	return all
