# SPDX-License-Identifier: MIT
class_name SupervisorWatch
extends RefCounted
## Whether the supervisor that started this program is still there. Without one nobody would end it:
## it would stay on the screen when the supervisor has been ended.

## On the command line, after --: the supervisor's process.
const ARGUMENT: String = "--supervised-by="
const PROCESSES: String = "/proc"


## The argument by which this process is named to the program that it starts.
static func argument() -> String:
	return ARGUMENT + str(OS.get_process_id())


## False where there is no supervisor, and where the system does not tell (there is no /proc).
static func is_gone(arguments: PackedStringArray) -> bool:
	var process := CommandLine.value(arguments, ARGUMENT)
	if process.is_empty() or not DirAccess.dir_exists_absolute(PROCESSES.path_join("self")):
		return false
	return not _lives(process)


# One that has ended and that nobody has asked about yet still has its folder.
static func _lives(process: String) -> bool:
	var state := FileAccess.open(PROCESSES.path_join(process).path_join("stat"), FileAccess.READ)
	return state != null and not state.get_line().contains(") Z")
