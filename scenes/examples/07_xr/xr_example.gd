# SPDX-License-Identifier: MIT
extends Node3D
## A headset in ten nodes: the hole before the visitor, each eye with its own sky. Without a headset
## the window shows the same from where the head would be.

@onready var _sky: BlackHoleSky = $Sky


func _ready() -> void:
	# Half a metre wide: one can walk round it.
	_sky.schwarzschild_radius = 0.25
	# The eyes are farther apart than the picture can be brought together at the shadow's edge.
	_sky.stereo_baseline_scale = 0.1
	var interface := XRServer.find_interface("OpenXR")
	if interface == null or not interface.is_initialized():
		push_warning("There is no headset: start with --xr-mode on and an OpenXR runtime.")
		return
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)
	get_viewport().use_xr = true
