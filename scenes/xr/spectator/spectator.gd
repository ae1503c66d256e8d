# SPDX-License-Identifier: MIT
class_name Spectator
extends CanvasLayer
## What the desktop's window shows while somebody is inside: their view, held steady, or what each
## eye sees, with a sentence below for those who stand around.
##
## The pictures are drawn at a pace of their own and not larger than needed: the headset goes first.

enum Mode {
	## The visitor's view without the head's trembling and roll.
	VIEW,
	## What each eye sees, side by side.
	BOTH_EYES,
	## The caption alone.
	OFF,
}

const CAPTION_SECONDS: float = 0.25
## Half the distance of the eyes where no headset tells it, metres.
const HALF_EYES: float = 0.0315
## Heights of the letters' lines, in parts of the window's height: legible from three metres on a
## screen of 1080 rows.
const CAPTION_SHARE: float = 0.042
const DISTANCE_SHARE: float = 0.029

@export var mode: Mode = Mode.VIEW:
	set(value):
		mode = value
		if is_node_ready():
			_arrange()
## Whose view is shown. Its parent is taken for the rig that carries it.
@export var head: Node3D
## Nothing is shown while the headset shows nothing; empty: always shown.
@export var session: XrSession
@export var sky: BlackHoleSky
## How often the pictures are drawn; 0: with every frame.
@export_range(0.0, 120.0, 1.0, "suffix:Hz") var pictures_per_second: float = 30.0
## How far the steadied view lags behind.
@export_range(0.0, 2.0, 0.05, "suffix:s") var smoothing: float = 0.4
## When the head moves by more than this part of the distance to the hole within a frame, the view
## goes with it at once.
@export_range(0.01, 1.0, 0.01) var jump: float = 0.15
## From the picture's lower edge to the upper.
@export_range(20.0, 120.0, 1.0, "suffix:°") var field: float = 70.0
## The picture has no more rows than this.
@export_range(120, 2160, 1, "suffix:px") var most_rows: int = 1080
## Render layers that are shown; by default all but the second, for what only the visitor sees.
@export_flags_3d_render var cull_mask: int = 0xFFFFF & ~2

var _steady := SteadyPose.new()
var _is_settled: bool = false
var _last_place := Vector3.ZERO
var _since_picture: float = INF
var _since_caption: float = INF

@onready var _frame: Control = %Frame
@onready var _pictures: Array[TextureRect] = [%Left, %Right]
@onready var _viewports: Array[SubViewport] = [%LeftViewport, %RightViewport]
@onready var _cameras: Array[Camera3D] = [%LeftCamera, %RightCamera]
@onready var _caption: Label = %Caption
@onready var _distance: Label = %Distance


func _ready() -> void:
	# After whatever moves the head.
	process_priority = 100
	for eye in 2:
		_pictures[eye].texture = _viewports[eye].get_texture()
		# Compatibility stores display values whatever the buffer; 8 bits are what it shows.
		_viewports[eye].use_hdr_2d = (
			RenderingServer.get_current_rendering_method() != "gl_compatibility"
		)
	_frame.resized.connect(_fit)
	_fit()
	_arrange()


func _process(delta: float) -> void:
	var is_wanted := mode == Mode.OFF or session == null or session.is_shown()
	if is_wanted != visible:
		visible = is_wanted
		_arrange()
	if not visible or mode == Mode.OFF:
		return
	_follow(delta)
	_since_picture += delta
	if pictures_per_second <= 0.0 or _since_picture >= 1.0 / pictures_per_second:
		_since_picture = 0.0
		_draw_pictures()
	_since_caption += delta
	if _since_caption >= CAPTION_SECONDS:
		_since_caption = 0.0
		_show_distance()


## The sentence below the picture, in English or as it shall stand there; empty: none.
func set_caption(text: String) -> void:
	_caption.text = text
	_caption.visible = not text.is_empty()
	_arrange_words()


func get_caption() -> String:
	return _caption.text


## The view of VIEW, in the world.
func get_view() -> Transform3D:
	return Transform3D(_steady.get_basis(), _rig() * _steady.get_place())


func _follow(delta: float) -> void:
	var rig := _rig()
	var place := head.global_position
	var view := head.global_basis
	var far := jump * place.distance_to(sky.global_position)
	_steady.seconds = smoothing
	# The rig's own motion is smooth and often fast: only the head in it is held back.
	if not _is_settled or place.distance_to(_last_place) > far:
		_steady.settle(rig.affine_inverse() * place, view, rig.basis.y.normalized())
		_since_picture = INF
		_is_settled = true
	else:
		_steady.follow(rig.affine_inverse() * place, view, rig.basis.y.normalized(), delta)
	_last_place = place


func _draw_pictures() -> void:
	for eye in 2 if mode == Mode.BOTH_EYES else 1:
		_cameras[eye].global_transform = get_view() if mode == Mode.VIEW else _eye_pose(eye)
		_viewports[eye].render_target_update_mode = SubViewport.UPDATE_ONCE


func _eye_pose(eye: int) -> Transform3D:
	var interface := session.get_interface() if session != null else null
	if interface != null and interface.get_view_count() > 1:
		return interface.get_transform_for_view(eye, _rig()).orthonormalized()
	var aside := Vector3.RIGHT * (-HALF_EYES if eye == 0 else HALF_EYES)
	return head.global_transform.orthonormalized() * Transform3D(Basis.IDENTITY, aside)


func _rig() -> Transform3D:
	var rig := head.get_parent_node_3d()
	return rig.global_transform if rig != null else Transform3D.IDENTITY


func _show_distance() -> void:
	_distance.text = (
		tr("%s from the hole") % ReadoutText.distance(sky.distance_to(head.global_position))
	)


# What is seen of the parts, and which of the cameras look: one that looks costs the sky work, even
# where nothing is drawn for it.
func _arrange() -> void:
	for eye in 2:
		var is_seen := visible and mode != Mode.OFF and (eye == 0 or mode == Mode.BOTH_EYES)
		_pictures[eye].visible = is_seen
		_cameras[eye].current = is_seen
		if not is_seen:
			_viewports[eye].render_target_update_mode = SubViewport.UPDATE_DISABLED
	for part: CanvasItem in [%Between, %LeftName, %RightName]:
		part.visible = mode == Mode.BOTH_EYES
	_is_settled = false
	_since_picture = INF
	_since_caption = INF
	_arrange_words()
	_fit.call_deferred()


func _arrange_words() -> void:
	_distance.visible = mode != Mode.OFF
	(%Shade as CanvasItem).visible = _distance.visible or _caption.visible


func _fit() -> void:
	var rows := _frame.size.y
	_caption.add_theme_font_size_override(&"font_size", roundi(CAPTION_SHARE * rows))
	for small: Label in [_distance, %LeftName, %RightName]:
		small.add_theme_font_size_override(&"font_size", roundi(DISTANCE_SHARE * rows))
	var near_camera := head as Camera3D
	for eye in 2:
		var extent := _pictures[eye].size * get_window().content_scale_factor
		extent *= minf(most_rows / maxf(extent.y, 1.0), 1.0)
		var pixels := Vector2i(extent.round()).max(Vector2i(16, 16))
		if _viewports[eye].size != pixels:
			_viewports[eye].size = pixels
		_cameras[eye].fov = field
		_cameras[eye].cull_mask = cull_mask
		if near_camera != null:
			_cameras[eye].near = near_camera.near
			_cameras[eye].far = near_camera.far
