# SPDX-License-Identifier: MIT
class_name RoomFrame
extends MeshInstance3D
## A faint globe of lines that stays with the room: while the visitor is moved it stands still and
## tells the balance that oneself does not. Child of the origin.

const METRES: float = 3.0
const MERIDIANS: int = 12
## Parallels from pole to pole, without the poles.
const PARALLELS: int = 7
const SEGMENTS: int = 48
const BRIGHTNESS: float = 0.09
## Seconds in which it comes and goes.
const FADING_SECONDS: float = 0.25
## Its middle is as high as most eyes, metres.
const EYE_HEIGHT: float = 1.6

@export var rig: XrRig
@export var comfort: Comfort

var _strength: float = 0.0
var _material := StandardMaterial3D.new()


func _init() -> void:
	_material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	_material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	_material.blend_mode = BaseMaterial3D.BLEND_MODE_ADD
	_material.disable_fog = true
	_material.render_priority = Material.RENDER_PRIORITY_MAX - 3
	mesh = _globe()
	material_override = _material
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	layers = 2  # for the visitor alone
	position.y = EYE_HEIGHT
	visible = false


func _process(delta: float) -> void:
	var asked := rig.get_motion() if comfort.fixed_frame else 0.0
	_strength = lerpf(asked, _strength, exp(-delta / FADING_SECONDS))
	visible = _strength > 0.01
	if visible:
		var grey := BRIGHTNESS * _strength
		_material.albedo_color = Color(grey, grey, grey * 1.2, 1.0)


## How strongly it is seen, 0 to 1.
func get_strength() -> float:
	return _strength


static func _globe() -> ArrayMesh:
	var points: PackedVector3Array = []
	for meridian in MERIDIANS:
		var azimuth := TAU * meridian / MERIDIANS
		for i in range(2, SEGMENTS - 2):
			points.append(_on_globe(PI * i / SEGMENTS, azimuth))
			points.append(_on_globe(PI * (i + 1) / SEGMENTS, azimuth))
	for parallel in range(1, PARALLELS + 1):
		for i in SEGMENTS:
			var polar := PI * parallel / (PARALLELS + 1)
			points.append(_on_globe(polar, TAU * i / SEGMENTS))
			points.append(_on_globe(polar, TAU * (i + 1) / SEGMENTS))
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = points
	var lines := ArrayMesh.new()
	lines.add_surface_from_arrays(Mesh.PRIMITIVE_LINES, arrays)
	return lines


static func _on_globe(polar: float, azimuth: float) -> Vector3:
	return METRES * Vector3(sin(polar) * cos(azimuth), cos(polar), sin(polar) * sin(azimuth))
