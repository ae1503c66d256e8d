# SPDX-License-Identifier: MIT
class_name XrShot
extends Node
## Takes a shot as a headset shows it: the same world, drawn for both eyes by the OpenXR session,
## the head where the shot has its eye. The picture has the left eye's on its left half.
##
## What the headset shows decides the size and the field of view, not the shot.

## So long the session may take to come, and the picture, seconds.
const PATIENCE_SECONDS: float = 20.0

var _viewport := SubViewport.new()
var _origin := XROrigin3D.new()
var _head := XRCamera3D.new()
var _session := XrSession.new()


func _init() -> void:
	_viewport.size = Vector2i(512, 512)
	_origin.current = true
	_head.near = 0.01
	_head.current = true
	_session.viewport = _viewport
	_origin.add_child(_head)
	_viewport.add_child(_origin)
	add_child(_viewport)
	add_child(_session)


## Opens the session; returns why there is none, or nothing.
func open(world: World3D) -> String:
	_viewport.world_3d = world
	if RenderingServer.get_rendering_device() == null:
		return "xr: both eyes are taken with mobile and forward_plus only."
	if not _session.start():
		return "xr: there is no OpenXR runtime; ./run capture brings a simulated one."
	if not await _until(_session.has_focus):
		return "xr: the OpenXR session did not come into focus."
	if not await _until(func() -> bool: return _session.get_head_pose() != Transform3D.IDENTITY):
		return "xr: the headset does not say where the head is."
	return ""


## Both eyes' pictures side by side, linear light (RGBAF), with the head as `eye` has it; null when
## the runtime gives none.
func take(eye: Transform3D, far: float) -> Image:
	_head.far = far
	# The first frames compile what they draw with.
	for frame in ShotStage.WARM_UP_FRAMES:
		_origin.global_transform = eye * _session.get_head_pose().affine_inverse()
		await RenderingServer.frame_post_draw
	var pictures := await EyeCapture.take(_head, PATIENCE_SECONDS)
	return _side_by_side(pictures[0], pictures[1]) if pictures.size() == 2 else null


func _until(is_so: Callable) -> bool:
	return await Waiting.until(get_tree(), is_so, PATIENCE_SECONDS)


static func _side_by_side(left: Image, right: Image) -> Image:
	var size := left.get_size()
	var both := Image.create_empty(2 * size.x, size.y, false, left.get_format())
	both.blit_rect(left, Rect2i(Vector2i.ZERO, size), Vector2i.ZERO)
	both.blit_rect(right, Rect2i(Vector2i.ZERO, size), Vector2i(size.x, 0))
	return both
