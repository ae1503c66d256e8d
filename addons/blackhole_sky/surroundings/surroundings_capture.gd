# SPDX-License-Identifier: MIT
@tool
class_name SurroundingsCapture
extends Node
## Shows the scene round a black hole bent by it: an everyday room, a hall, a landscape.
##
## Best a child of a [BlackHoleSky], it takes six square views of 90 degrees from the hole's middle
## and sets them as [member BlackHoleSky.surroundings], for
## [constant BlackHoleSky.BACKGROUND_SURROUNDINGS]. All that is in them counts as infinitely far
## away: whoever moves sees the room as from the hole's place, and the hole move before it.
## [br][br]
## What shall be captured has the render layers of [member cull_mask], the second one at first.
## Leave these out of the cull masks of the cameras that look at the hole, or the room is drawn
## once more as it is. Lights belong on these layers too: lamps shine for the cameras that see
## theirs. All else stays an ordinary part of the scene, before the sky.
## [br][br]
## Views are linear light without tone mapping, which is left to the camera that looks at the sky:
## the room is as bright as it was, at [member BlackHoleSky.panorama_luminance] 1 and
## [member BlackHoleSky.exposure] 0. In the Compatibility renderer they are display values of 8
## bits. Effects of the screen are left out, since their seams would show. Moving observers see the
## light shifted like any other, unless [member BlackHoleSky.panorama_is_light] is off.
## [br][br]
## A capture draws the scene six times, and reads nothing back from the graphics card.

## The views have been drawn, once.
signal captured

## When the views are drawn.
enum UpdateMode {
	## When the node has come into the scene, and when [method capture] asks for it.
	ONCE,
	## For every picture.
	ALWAYS,
}

@export var update_mode := UpdateMode.ONCE:
	set(value):
		update_mode = value
		_restart()
## Render layers that are captured. The sky's own must not be among them.
@export_flags_3d_render var cull_mask: int = 2:
	set(value):
		cull_mask = value
		update_configuration_warnings()
		_restart()
## Texels along the edge of a view. What the hole magnifies shows them: 512 are a tenth of a degree
## each, and two pixels wide in a picture of 720 rows and 60 degrees.
@export_enum("128:128", "256:256", "512:512", "1024:1024", "2048:2048") var resolution: int = 512:
	set(value):
		resolution = clampi(nearest_po2(value), 128, 2048)
		_restart()
## How smooth edges are. They are magnified by the hole, so smoothness pays.
@export var msaa_3d := Viewport.MSAA_4X:
	set(value):
		msaa_3d = value
		_restart()
## What is nearer to the hole's middle is left out.
@export_range(0.01, 10.0, 0.01, "or_less", "or_greater", "suffix:m") var near: float = 0.05:
	set(value):
		near = maxf(value, 1e-3)
		_restart()
## What is farther away is left out.
@export_range(1.0, 10000.0, 0.1, "or_greater", "exp", "suffix:m") var far: float = 1000.0:
	set(value):
		far = maxf(value, 1e-2)
		_restart()
## Background and ambient light of the views; empty: the world's own, as it is when the views are
## set up, that is when a property changes or [method capture] is called.
@export var environment: Environment:
	set(value):
		environment = value
		_restart()
## The sky that is given the views; empty: the parent.
@export var sky: BlackHoleSky:
	set(value):
		_take_back()
		sky = value
		_hand_over()
		update_configuration_warnings()
		_restart()
@export_tool_button("Capture", "Camera3D") var _capture_button: Callable = capture

var _views := SurroundingsViews.new()
var _waits: bool = false
var _draws: bool = false
var _last_place := Transform3D(Basis(), Vector3.INF)


func _init() -> void:
	_views.name = &"Views"
	add_child(_views, false, INTERNAL_MODE_BACK)


func _enter_tree() -> void:
	if sky == null:
		sky = get_parent() as BlackHoleSky
	_hand_over()
	RenderingServer.frame_pre_draw.connect(_before_draw)
	RenderingServer.frame_post_draw.connect(_after_draw)
	_restart()


func _exit_tree() -> void:
	RenderingServer.frame_pre_draw.disconnect(_before_draw)
	RenderingServer.frame_post_draw.disconnect(_after_draw)
	_take_back()


func _get_configuration_warnings() -> PackedStringArray:
	var warnings := PackedStringArray()
	if sky == null:
		warnings.append("There is no sky. Make it a child of a BlackHoleSky, or set `sky`.")
	elif sky.render_layers & cull_mask != 0:
		warnings.append(
			(
				"The sky would be captured itself. Give `cull_mask` layers that are not among "
				+ "the sky's `render_layers`, and put the room on them."
			)
		)
	return warnings


## Draws the views for the next picture, with the world's environment as it is then; await
## [signal captured] for the end.
func capture() -> void:
	_restart()


# All that is set takes effect before the next picture is drawn.
func _restart() -> void:
	_waits = true


func _before_draw() -> void:
	if sky == null or not sky.is_inside_tree():
		return
	if _waits:
		_set_up()
	var at := sky.global_transform.orthonormalized()
	if _waits or (update_mode == UpdateMode.ALWAYS and at != _last_place):
		_last_place = at
		_views.place(at)
	_draws = _waits
	_waits = false


func _after_draw() -> void:
	if _draws:
		_draws = false
		captured.emit()


func _set_up() -> void:
	_views.set_lens(resolution, near, far)
	_views.set_look(cull_mask, _plain_environment(), msaa_3d)
	_views.rest()
	_views.draw(update_mode == UpdateMode.ALWAYS)


func _hand_over() -> void:
	if sky != null and is_inside_tree():
		sky.surroundings = _views.get_texture()


func _take_back() -> void:
	if sky != null and sky.surroundings == _views.get_texture():
		sky.surroundings = null
	_views.rest()


# Without what belongs to a picture on the screen.
func _plain_environment() -> Environment:
	var world := environment
	if world == null:
		var around := _views.find_world_3d()
		world = around.environment if around.environment != null else around.fallback_environment
	var plain: Environment = world.duplicate() if world != null else Environment.new()
	plain.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	plain.tonemap_exposure = 1.0
	for effect: String in ["glow", "ssao", "ssil", "ssr", "adjustment", "volumetric_fog"]:
		plain.set(effect + "_enabled", false)
	return plain
