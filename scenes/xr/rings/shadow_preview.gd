# SPDX-License-Identifier: MIT
class_name ShadowPreview
extends Node3D
## Shows, while a ring is pointed at, how large the shadow is there: a circle round the hole and the
## angle in words.

const COLOUR := Color(1.0, 0.78, 0.42)
## Width of the circle's line, and height of the words, degrees as seen from the head.
const LINE_DEGREES: float = 0.25
const TEXT_DEGREES: float = 2.6
## Nothing larger is drawn, radians from the middle.
const LARGEST: float = 1.2

@export var rig: XrRig
@export var head: Node3D
@export var sky: BlackHoleSky
@export var jump: RingJump

var _circle := MeshInstance3D.new()
var _torus := TorusMesh.new()
var _words: String
var _text := FloatingWords.new()


func _ready() -> void:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = COLOUR
	material.no_depth_test = true
	material.render_priority = 10
	_torus.rings = 96
	_torus.ring_segments = 6
	_circle.mesh = _torus
	_circle.material_override = material
	_circle.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	_text.colour = COLOUR
	add_child(_circle)
	add_child(_text)
	visible = false
	jump.pointed_at_ring.connect(show_ring)


## Shows what is seen at `radius` (Schwarzschild radii); 0: nothing.
func show_ring(radius: float) -> void:
	visible = radius > 0.0
	if not visible:
		return
	var half_angle := RingJump.shadow_there(radius)
	_words = (
		tr("At %s the shadow is %.0f° wide")
		% [ReadoutText.plain(radius) + " rₛ", rad_to_deg(2.0 * half_angle)]
	)
	_lay(minf(half_angle, LARGEST))


func _lay(half_angle: float) -> void:
	var eye := head.global_position
	var distance := rig.get_radius_metres()
	var radius := distance * tan(half_angle)
	var line := distance * tan(deg_to_rad(LINE_DEGREES)) / cos(half_angle)
	_torus.inner_radius = radius - 0.5 * line
	_torus.outer_radius = radius + 0.5 * line
	global_transform = Transform3D(Basis.looking_at(sky.global_position - eye), sky.global_position)
	# The torus lies flat; the circle faces the eye.
	_circle.basis = Basis(Vector3.RIGHT, 0.5 * PI)
	_text.set_words(_words, distance * tan(deg_to_rad(TEXT_DEGREES)))
	_text.position = Vector3.ZERO  # in the shadow, where there is nothing to see


func _process(_delta: float) -> void:
	if visible and jump.get_ring() == 0.0:
		visible = false
