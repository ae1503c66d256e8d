# SPDX-License-Identifier: MIT
class_name ValueSlider
extends HSlider
## A slider with its value in words beside it.

@export var label: Label


## Shows a value without emitting that it has changed. What the slider cannot show exactly the words
## can.
func display(shown: float, text: String) -> void:
	set_value_no_signal(shown)
	label.text = text
