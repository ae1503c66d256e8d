# SPDX-License-Identifier: MIT
class_name VisitClock
extends PanelContainer
## Tells a visitor that the visit ends soon, and how long it still lasts.

var _shown: int = -1

@onready var _label: Label = %Left


## Shows what is left, in seconds; INF hides it.
func show_left(seconds: float) -> void:
	visible = is_finite(seconds)
	if not visible:
		_shown = -1
		return
	var whole := ceili(seconds)
	if whole != _shown:
		_shown = whole
		_label.text = tr("Your visit ends in %d seconds.") % whole
