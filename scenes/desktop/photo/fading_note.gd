# SPDX-License-Identifier: MIT
class_name FadingNote
extends PanelContainer
## Words that go away by themselves.

const FADE_SECONDS: float = 0.6

var _fading: Tween

@onready var _label: Label = $Text


## Shows a text for `seconds`; INF keeps it until the next.
func tell(text: String, seconds: float) -> void:
	_label.text = text
	modulate.a = 1.0
	show()
	if _fading != null:
		_fading.kill()
	if is_finite(seconds):
		_fading = create_tween()
		_fading.tween_interval(seconds)
		_fading.tween_property(self, ^"modulate:a", 0.0, FADE_SECONDS)
		_fading.tween_callback(hide)


func get_text() -> String:
	return _label.text
