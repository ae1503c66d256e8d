# SPDX-License-Identifier: MIT
class_name SplitPicture
extends RefCounted
## Moves the middle of a camera's picture into the left part of its window, without moving the eye.


## The picture's middle is then that of the left `share` (0 to 1) of the window; angles keep their
## size. The frustum is shifted: its size and offset are those at the near plane.
static func show_beside(camera: Camera3D, share: float) -> void:
	var extent := camera.get_viewport().get_visible_rect().size
	var height := 2.0 * camera.near * tan(0.5 * deg_to_rad(camera.fov))
	var width := height * extent.x / maxf(extent.y, 1.0)
	camera.projection = Camera3D.PROJECTION_FRUSTUM
	camera.size = height
	camera.frustum_offset = Vector2(0.5 * (1.0 - share) * width, 0.0)


static func show_whole(camera: Camera3D) -> void:
	camera.projection = Camera3D.PROJECTION_PERSPECTIVE
