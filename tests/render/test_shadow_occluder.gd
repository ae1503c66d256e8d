# SPDX-License-Identifier: MIT
extends GutTest
## What stands behind the hole does not show through its shadow, for every observer, and what stands
## before it does.

const OBSERVERS: Array = [
	[LensingTable.MOTION_STATIC, 6.0],
	[LensingTable.MOTION_RAIN, 3.0],
	[LensingTable.MOTION_ORBIT, 4.0],
	[LensingTable.MOTION_STATIC, 1.4],
]

var _booth: SkyBooth
var _ball := MeshInstance3D.new()
var _occluder := ShadowOccluder.new()
## Direction of the shadow's middle.
var _middle: Vector3

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_booth.sky.add_child(_occluder)
	_ball.mesh = SphereMesh.new()
	_booth.viewport.add_child(_ball)
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_ball.material_override = _material(Color.WHITE)
	_ball.show()
	_occluder.show()
	_booth.sky.lensing = 1.0
	_booth.sky.background = BlackHoleSky.BACKGROUND_NONE


## A ball so large that it is all that is seen, beyond the hole.
func test_the_shadow_is_black_and_the_rest_is_not(
	p: Array = use_parameters(RendererScope.fewer(OBSERVERS, 2))
) -> void:
	var view := _view(p)
	_put_ball(view, 80.0, 72.0)
	await _judge(view, view.shadow_half_angle(), "%s" % [p])


func test_a_hole_that_vanishes_hides_less() -> void:
	var view := _view([LensingTable.MOTION_STATIC, 6.0])
	_put_ball(view, 80.0, 72.0)
	_booth.sky.lensing = 0.5
	var half := ExactView.new(view.place * 2.0, LensingTable.MOTION_STATIC).shadow_half_angle()
	await _judge(view, half, "half a hole")
	_booth.sky.lensing = 0.0
	var picture := await _booth.take()
	assert_gt(picture.get_pixelv(_middle_of(picture.get_size())).g, 0.9, "none")


func test_what_is_nearer_than_the_hole_is_seen() -> void:
	var view := _view([LensingTable.MOTION_STATIC, 6.0])
	_put_ball(view, 4.5, 0.4)
	var picture := await _booth.take()
	assert_gt(picture.get_pixelv(_middle_of(view.size)).g, 0.9)
	_put_ball(view, 9.0, 0.4)
	picture = await _booth.take()
	assert_eq(picture.get_pixelv(_middle_of(view.size)).g, 0.0)
	_occluder.hide()
	picture = await _booth.take()
	assert_gt(picture.get_pixelv(_middle_of(view.size)).g, 0.9, "the occluder has hidden it")


func test_transparent_things_behind_are_hidden_as_well() -> void:
	var view := _view([LensingTable.MOTION_STATIC, 6.0])
	_ball.material_override = _material(Color(1.0, 1.0, 1.0, 0.5))
	_put_ball(view, 9.0, 0.4)
	var picture := await _booth.take()
	assert_eq(picture.get_pixelv(_middle_of(view.size)).g, 0.0)
	_put_ball(view, 4.5, 0.4)
	picture = await _booth.take()
	assert_gt(picture.get_pixelv(_middle_of(view.size)).g, 0.2)


func test_the_disk_before_and_in_the_shadow_stays() -> void:
	var view := _view([LensingTable.MOTION_STATIC, 6.0])
	_ball.hide()
	var disk := AccretionDisk.new()
	disk.look = AccretionDisk.LOOK_CHECKERBOARD
	disk.plunging_gas = true
	disk.rotation.x = 0.3
	_booth.sky.add_child(disk)
	var with_occluder := await _booth.take()
	_occluder.hide()
	var without := await _booth.take()
	disk.free()
	assert_eq(with_occluder.get_data(), without.get_data())
	var lit := 0
	var across := floori(view.focal() * tan(view.shadow_half_angle()))
	var middle := _middle_of(view.size)
	for x in range(middle.x - across, middle.x + across):
		for y in range(middle.y, middle.y + (across >> 1)):
			lit += 1 if without.get_pixel(x, y).g > 0.01 else 0
	assert_gt(lit, 500, "pixels of gas before the shadow")


func test_the_sky_is_the_same_with_it() -> void:
	_view([LensingTable.MOTION_STATIC, 6.0])
	_ball.hide()
	_booth.sky.background = BlackHoleSky.BACKGROUND_GRID
	_booth.sky.overlays = BlackHoleSky.OVERLAY_SHADOW_DIAMETER | BlackHoleSky.OVERLAY_SHADOW_EDGE
	var with_occluder := await _booth.take()
	_occluder.hide()
	var without := await _booth.take()
	_booth.sky.overlays = 0
	assert_eq(with_occluder.get_data(), without.get_data())


func _view(p: Array) -> ExactView:
	var motion: LensingTable.Motion = p[0]
	var r: float = p[1]
	var view := ExactView.new(Vector3(0.3, 0.4, 1.0).normalized() * r, motion)
	view.observer.axis = Vector3(0.1, 1.0, 0.0)
	view.size = Vector2i(640, 360)
	view.vertical_fov_deg = 80.0
	_middle = view.observer.shadow(view.place)["direction"]
	# Large shadows with their edge in the picture.
	var aside := Vector3(1.0, 0.2, 0.0) * maxf(view.shadow_half_angle() - 0.6, 0.0)
	view.look_along(ExactView.doubled(_middle + aside), Vector3.UP)
	_booth.aim(view)
	return view


## `away` from the eye, in the middle of the picture.
func _put_ball(view: ExactView, away: float, radius: float) -> void:
	var mesh: SphereMesh = _ball.mesh
	mesh.radius = radius
	mesh.height = 2.0 * radius
	_ball.position = view.place + Vec3D.to_vector3(view.forward) * away


func _material(colour: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	material.albedo_color = colour
	if colour.a < 1.0:
		material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	return material


## Pixels inside the circle round the shadow's middle are black, those outside are the ball's.
func _judge(view: ExactView, half_angle: float, what: String) -> void:
	var picture := await _booth.take()
	var wrong := 0
	var inside := 0
	var outside := 0
	for y in range(0, view.size.y, 2):
		for x in range(0, view.size.x, 2):
			var direction := view.to_direction(Vector2(x + 0.5, y + 0.5))
			var off := (
				acos(clampf(Vec3D.dot(direction, ExactView.doubled(_middle)), -1.0, 1.0))
				- half_angle
			)
			# A pixel of the edge may be either.
			if absf(off) * view.focal() < 1.5:
				continue
			inside += 1 if off < 0.0 else 0
			outside += 1 if off > 0.0 else 0
			var light := picture.get_pixel(x, y).g
			wrong += 1 if (off < 0.0 and light > 0.0) or (off > 0.0 and light < 0.9) else 0
	assert_gt(inside, 100, "%s: pixels of the shadow" % what)
	assert_gt(outside, 100, "%s: pixels beside it" % what)
	assert_eq(wrong, 0, "%s: pixels that are wrong" % what)


func _middle_of(size: Vector2i) -> Vector2i:
	return Vector2i(size.x >> 1, size.y >> 1)
