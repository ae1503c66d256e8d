# SPDX-License-Identifier: MIT
extends GutHookScript
## Pre-run hook that calls the run off.


func run() -> void:
	abort()
