# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## The material of lines that lie over the sky.
##
## The materials that the engine makes for gizmos are drawn first among what is transparent, so the
## layers of the sky would hide them.


## Lines of one colour; `facing` turns them to the camera.
static func make(color: Color, facing: bool = false) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.albedo_color = color
	material.disable_fog = true
	material.render_priority = 1
	if facing:
		material.billboard_mode = BaseMaterial3D.BILLBOARD_ENABLED
	return material
