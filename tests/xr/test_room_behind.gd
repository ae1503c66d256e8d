# SPDX-License-Identifier: MIT
extends XrTestCase
## What is behind the hole, in both eyes: an object does not show through the shadow, the room does
## show through a clear sky, and without a headset that can do so the room is not offered.

const RADIUS: float = 0.3
const DISTANCE: float = 6.0
const AZIMUTHS: int = 24


func test_a_wall_behind_is_hidden_in_the_shadow_of_each_eye() -> void:
	if not await begun():
		return
	_place_hole()
	var sky := visit.scene.sky
	var occluder := ShadowOccluder.new()
	sky.add_child(occluder)
	var wall := MeshInstance3D.new()
	var quad := QuadMesh.new()
	quad.size = Vector2(40.0, 40.0)
	wall.mesh = quad
	var white := StandardMaterial3D.new()
	white.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	wall.material_override = white
	visit.scene.add_child(wall)
	wall.global_position = sky.global_position + Vector3(0.0, 0.0, -1.5)
	var pictures := await _take()
	assert_eq(pictures.size(), 2)
	for view in pictures.size():
		var eye := EyeView.new(visit.scene, view, pictures[view].get_size())
		assert_eq(_wrong(eye, pictures[view], 0.92, true), 0, "eye %d: within" % view)
		assert_eq(_wrong(eye, pictures[view], 1.08, false), 0, "eye %d: beside" % view)
		# From the other eye's place the shadow would stand elsewhere.
		var from_other := EyeView.new(visit.scene, 1 - view, pictures[view].get_size()).place
		eye.place = from_other
		assert_gt(
			_wrong(eye, pictures[view], 0.92, true) + _wrong(eye, pictures[view], 1.08, false), 0
		)
	wall.free()


func test_a_clear_sky_lets_the_room_through_in_both_eyes() -> void:
	if not await begun():
		return
	_place_hole()
	var passthrough := Passthrough.new()
	passthrough.session = visit.scene.session
	passthrough.viewport = visit.scene.session.viewport
	passthrough.sky = visit.scene.sky
	visit.scene.add_child(passthrough)
	gut.p("passthrough: '%s'" % passthrough.why_not())
	assert_eq(passthrough.set_on(true), passthrough.is_offered())
	if not passthrough.is_on():
		passthrough.call("_show_room", true)
	var pictures := await _take()
	assert_eq(pictures.size(), 2)
	for view in pictures.size():
		var eye := EyeView.new(visit.scene, view, pictures[view].get_size())
		var middle := eye.to_pixel(_middle(eye))
		assert_eq(pictures[view].get_pixelv(middle.floor()), Color.BLACK, "the shadow")
		assert_lt(pictures[view].get_pixel(1, 1).a, 0.05, "the room")
	passthrough.set_on(false)
	assert_false(passthrough.is_on())


func _place_hole() -> void:
	var sky := visit.scene.sky
	sky.background = BlackHoleSky.BACKGROUND_NONE
	sky.stars_visible = false
	sky.stereo_baseline_scale = 1.0
	sky.schwarzschild_radius = RADIUS


func _take() -> Array[Image]:
	var scene := visit.scene
	var eyes := Vector3(0.2, 1.5, 0.3)
	assert_true(await visit.move_head(Transform3D(Basis.IDENTITY, eyes)), "head moved")
	scene.sky.global_position = eyes + Vector3(0.0, 0.05, -1.0).normalized() * RADIUS * DISTANCE
	return await take_pictures()


func _middle(eye: EyeView) -> Vector3:
	return eye.place.direction_to(visit.scene.sky.global_position)


## Pixels on a circle round the shadow's middle, `part` of its own as wide, that are not as dark or
## as bright as they should be.
func _wrong(eye: EyeView, picture: Image, part: float, dark: bool) -> int:
	var sky := visit.scene.sky
	var resting := SkyObserver.new()
	var place := (eye.place - sky.global_position) / sky.schwarzschild_radius
	var half: float = resting.shadow(place)["half_angle"]
	var middle := _middle(eye)
	var right := middle.cross(Vector3.UP).normalized()
	var wrong := 0
	for i in AZIMUTHS:
		var beside := right.rotated(middle, TAU * i / AZIMUTHS)
		var pixel := eye.to_pixel(middle * cos(part * half) + beside * sin(part * half))
		if eye.holds(pixel, 2.0):
			wrong += 1 if (picture.get_pixelv(pixel.floor()).g < 0.1) != dark else 0
	return wrong
