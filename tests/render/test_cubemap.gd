# SPDX-License-Identifier: MIT
extends GutTest
## Every pixel of a lensed cube map shows the place on the sky where its ray ends, and does not
## shimmer.

const SIZE: int = 128

var _booth: SkyBooth
var _rng := RandomNumberGenerator.new()

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_all() -> void:
	_rng.seed = 2
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_booth.sky.panorama_is_light = false
	_booth.sky.background = BlackHoleSky.BACKGROUND_CUBEMAP
	_booth.sky.cubemap = _directions_as_colours()
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func test_rays_end_where_the_exact_solution_says() -> void:
	_booth.sky.basis = Basis.from_euler(Vector3(0.3, 0.2, -0.8))
	var view := ExactView.new(Vector3(2.0, 1.0, -2.0), LensingTable.MOTION_STATIC)
	view.look_beside(view.shadow_half_angle() + 0.3, Vector3(0.2, 1.0, 0.4))
	_booth.aim(view)
	var picture := await _booth.take()
	var worst := 0.0
	var measured := 0
	while measured < 100:
		var pixel := Vector2i(_rng.randi_range(0, 1278), _rng.randi_range(0, 718))
		var exact := _exact(view, pixel)
		if exact == Vector3.ZERO:
			continue
		var seen := 2.0 * PicturePatch.colour(picture, pixel) - Vector3.ONE
		worst = maxf(worst, rad_to_deg(seen.distance_to(_booth.sky.basis.inverse() * exact)))
		measured += 1
	gut.p("worst of %d pixels %.3f degrees" % [measured, worst])
	assert_lt(worst, 0.2 if SkyBooth.is_linear() else 1.2)
	_booth.sky.basis = Basis.IDENTITY


func test_its_light_is_metered() -> void:
	var sky := _booth.sky
	sky.auto_exposure = true
	sky.adapt_at_once()
	var as_it_is := sky.get_effective_exposure()
	sky.panorama_luminance = 0.25
	sky.adapt_at_once()
	gut.p("%.2f and %.2f EV" % [as_it_is, sky.get_effective_exposure()])
	# Compatibility cannot read it back, and leaves the exposure to the manual one.
	var more := 2.0 if SkyBooth.is_linear() else 0.0
	assert_almost_eq(sky.get_effective_exposure() - as_it_is, more, 0.05)
	sky.panorama_luminance = 1.0
	sky.auto_exposure = false


func test_it_is_missed_when_there_is_none() -> void:
	var sky: BlackHoleSky = autofree(BlackHoleSky.new())
	sky.background = BlackHoleSky.BACKGROUND_CUBEMAP
	assert_string_contains("\n".join(sky.get_warnings()), "Set `cubemap`")
	sky.background = BlackHoleSky.BACKGROUND_SURROUNDINGS
	assert_string_contains("\n".join(sky.get_warnings()), "SurroundingsCapture")


## Where a pixel's ray ends; zero where it does not or where the pixel sees much of the sky.
func _exact(view: ExactView, pixel: Vector2i) -> Vector3:
	var ends: Array[Vector3] = []
	for offset: Vector2i in [Vector2i.ZERO, Vector2i.RIGHT, Vector2i.DOWN]:
		var at := Vector2(pixel + offset) + Vector2(0.5, 0.5)
		var ray := view.observer.trace(view.place, Vec3D.to_vector3(view.to_direction(at)))
		if ray["captured"]:
			return Vector3.ZERO
		ends.append(ray["sky_direction"])
	if maxf(ends[0].angle_to(ends[1]), ends[0].angle_to(ends[2])) > 0.01:
		return Vector3.ZERO
	return ends[0]


## A cube map whose colours are directions: (d + 1) / 2.
func _directions_as_colours() -> Cubemap:
	var faces: Array[Image] = []
	for face in 6:
		var floats := PackedFloat32Array()
		for row in SIZE:
			for column in SIZE:
				var s := 2.0 * (column + 0.5) / SIZE - 1.0
				var t := 2.0 * (row + 0.5) / SIZE - 1.0
				var colour := 0.5 * _cube_point(face, s, t).normalized() + 0.5 * Vector3.ONE
				floats.append_array([colour.x, colour.y, colour.z])
		var image := Image.create_from_data(
			SIZE, SIZE, false, Image.FORMAT_RGBF, floats.to_byte_array()
		)
		image.generate_mipmaps()
		faces.append(image)
	var cubemap := Cubemap.new()
	cubemap.create_from_images(faces)
	return cubemap


## As graphics cards look for it (OpenGL 4.6, table 8.19).
static func _cube_point(face: int, s: float, t: float) -> Vector3:
	match face:
		0:
			return Vector3(1.0, -t, -s)
		1:
			return Vector3(-1.0, -t, s)
		2:
			return Vector3(s, 1.0, t)
		3:
			return Vector3(s, -1.0, -t)
		4:
			return Vector3(s, -t, 1.0)
	return Vector3(-s, -t, -1.0)
