# SPDX-License-Identifier: MIT
class_name GutHookScript
extends RefCounted
## Base of scripts that run before (pre_run_script) or after (post_run_script) all tests.

## The runner.
var gut: GutMain = null

var _exit_code: Variant = null
var _abort: bool = false


## Override: what the hook does. May await.
func run() -> void:
	pass


## In a pre-run hook: run no test. The run then exits with 1, since nothing was proved.
func abort() -> void:
	_abort = true


func should_abort() -> bool:
	return _abort


## In a post-run hook: the exit code of the run, in place of 0 or 1.
func set_exit_code(code: int) -> void:
	_exit_code = code


## The code given to set_exit_code, or null.
func get_exit_code() -> Variant:
	return _exit_code
