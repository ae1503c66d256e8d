# SPDX-License-Identifier: MIT
class_name PhotoLook
extends RefCounted
## What the photo mode changes of a picture, to be put back when it ends.

const SKY_PROPERTIES: Array[StringName] = [
	&"exposure", &"auto_exposure", &"psf_model", &"aperture_mm"
]

var _values: Dictionary[StringName, Variant] = {}
var _fov: float = 0.0


## What a sky and a camera are set to now.
static func of(sky: BlackHoleSky, camera: Camera3D) -> PhotoLook:
	var look := new()
	for property in SKY_PROPERTIES:
		look._values[property] = sky.get(property)
	look._fov = camera.fov
	return look


func put_back(sky: BlackHoleSky, camera: Camera3D) -> void:
	for property in SKY_PROPERTIES:
		sky.set(property, _values[property])
	camera.fov = _fov
