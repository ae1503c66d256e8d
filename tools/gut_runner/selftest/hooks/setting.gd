# SPDX-License-Identifier: MIT
extends GutHookScript
## Pre-run hook whose doing the tests can see.


func run() -> void:
	ProjectSettings.set_setting("runner/hooked", "hooked")
