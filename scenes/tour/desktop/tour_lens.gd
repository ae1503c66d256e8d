# SPDX-License-Identifier: MIT
class_name TourLens
extends RefCounted
## Moves the middle of a camera's picture upwards, out of the way of words at the lower edge, as a
## shift lens does: the eye neither moves nor turns.


## The picture's middle is then that of what is left when the lower `share` (0 to 1) of the window
## is covered; angles keep their size.
static func show_above(camera: Camera3D, share: float) -> void:
	var height := 2.0 * camera.near * tan(0.5 * deg_to_rad(camera.fov))
	camera.projection = Camera3D.PROJECTION_FRUSTUM
	camera.size = height
	camera.frustum_offset = Vector2(0.0, -0.5 * share * height)


static func show_whole(camera: Camera3D) -> void:
	camera.projection = Camera3D.PROJECTION_PERSPECTIVE
