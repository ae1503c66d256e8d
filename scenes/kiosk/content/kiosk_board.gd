# SPDX-License-Identifier: MIT
class_name KioskBoard
extends PanelSurface
## The exhibit's pages on a sign in the headset, before whoever puts it on. Child of the origin.

const PAGES: PackedScene = preload("res://scenes/kiosk/screens/kiosk_screens.tscn")
## The pages are laid out for so many pixels and drawn larger.
const LAYOUT := Vector2(800.0, 560.0)
const SHARPNESS: float = 2.0
## How far from the head, how wide, and how much below straight ahead.
const DISTANCE: float = 1.6
const WIDTH_DEGREES: float = 72.0
const LOWER_DEGREES: float = 6.0

## Render layer of its own, so that the pictures that call visitors do not show it.
const LAYER: int = 1 << 19

var screens: KioskScreens


func _ready() -> void:
	var across := roundi(SHARPNESS * LAYOUT.x)
	var metres := 2.0 * DISTANCE * tan(deg_to_rad(0.5 * WIDTH_DEGREES))
	dwell = 1.6
	resize(metres * Vector2(1.0, LAYOUT.y / LAYOUT.x), across)
	super()
	picture.layers = LAYER
	screens = PAGES.instantiate()
	screens.on_board = true
	var ground := ColorRect.new()
	ground.color = MenuLook.PANEL
	ground.size = LAYOUT
	ground.scale = SHARPNESS * Vector2.ONE
	screens.set_anchors_preset(Control.PRESET_FULL_RECT)
	ground.add_child(screens)
	show_content(ground)


## Shows the page of a step; none on the way.
func show_state(state: VisitDirector.State, head: Transform3D) -> void:
	if not visible and state != VisitDirector.State.VISIT:
		come_to(head)
	visible = state != VisitDirector.State.VISIT
	screens.show_state(state)
	hold_back()
	redraw()


## Comes before a head: upright in the room, turned to it by its bearing alone.
func come_to(head: Transform3D) -> void:
	var room := get_parent_node_3d()
	var pose := room.global_transform.affine_inverse() * head
	transform = XrRig.before(pose, DISTANCE, LOWER_DEGREES)
