# SPDX-License-Identifier: MIT
class_name EndingScreen
extends Control
## Thanks the visitor and asks for the place of the next one.

@onready var _request: Label = %Request


## `headset`: something is to be handed over.
func write(headset: bool) -> void:
	_request.text = (
		tr("Please take the headset off and hand it on to the next visitor.")
		if headset
		else tr("Please leave the place to the next visitor.")
	)
