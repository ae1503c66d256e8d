# SPDX-License-Identifier: MIT
class_name VisitSign
extends FloatingWords
## Words before the visitor, for a while: a countdown, what has just happened. Child of the origin,
## so that they stay where they are in the room.

## Away from the head, metres, and lower than straight ahead, degrees.
const METRES: float = 1.8
const LOWER_DEGREES: float = 14.0

@export var head: Node3D
## Height of an em as seen from the head.
@export_range(1.0, 10.0, 0.1, "suffix:°") var text_degrees: float = 3.0

var _left: float = 0.0


func _ready() -> void:
	super()
	# Over the veils as well: it may have to say why it is dark.
	material_override.render_priority = Material.RENDER_PRIORITY_MAX
	visible = false


func _process(delta: float) -> void:
	super(delta)
	if visible:
		set_process(true)
		_left -= delta
		visible = _left > 0.0


## Shows `words` before the visitor for `seconds`, in place of others.
func say(words: String, seconds: float = INF) -> void:
	if not visible:
		_place()
	_left = seconds
	set_words(words, METRES * tan(deg_to_rad(text_degrees)))
	visible = true


func clear() -> void:
	visible = false


func _place() -> void:
	var ahead := -head.global_basis.z
	ahead.y = 0.0
	ahead = ahead.normalized() if ahead.length() > 1e-3 else Vector3.FORWARD
	var down := Vector3.DOWN * tan(deg_to_rad(LOWER_DEGREES))
	var place := head.global_position + (ahead + down) * METRES
	look_at_from_position(place, place + place - head.global_position)
