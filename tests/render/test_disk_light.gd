# SPDX-License-Identifier: MIT
extends GutTest
## The light of the disk: as bright as the exact solution has it, on the scale of the stars, and
## hiding what is behind.

## Exposure at which the disk is as bright as a picture can hold.
const EXPOSURE_EV: float = -36.0
const WHITE: float = 0.5
## Luminance to which automatic exposure brings a uniform sky.
const KEY: float = 0.004
## Inclination in degrees, motion, radius in r_s, vertical field of view in degrees.
const VIEWS: Array = [
	[80.0, LensingTable.MOTION_STATIC, 20.0, 60.0],
	[60.0, LensingTable.MOTION_ORBIT, 12.0, 90.0],
	[100.0, LensingTable.MOTION_RAIN, 8.0, 110.0],
]

var _booth: SkyBooth
var _disk: AccretionDisk

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_each() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_disk = AccretionDisk.new()
	_disk.outer_radius = 15.0
	_disk.outer_fade = 0.0
	_booth.sky.add_child(_disk)
	add_child(_booth)


func after_each() -> void:
	_booth.free()


func test_brightness(p: Array = use_parameters(VIEWS)) -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility keeps no linear light")
		return
	_booth.sky.exposure = EXPOSURE_EV
	var seen := _aim(p[0], p[1], p[2], p[3])
	seen.view.size = Vector2i(192, 108)
	_booth.aim(seen.view)
	var picture := PictureMeasure.of_image(await _booth.take())
	var exact := ExactDiskLight.new()
	var found := Vector2.ZERO
	var expected := Vector2.ZERO
	for y in seen.view.size.y:
		for x in seen.view.size.x:
			var side := Vector2.RIGHT if x < 0.5 * seen.view.size.x else Vector2.DOWN
			found += side * picture.at(x, y)
			expected += side * exact.of_pixel(seen, Vector2i(x, y)) * pow(2.0, EXPOSURE_EV)
	gut.p("%s: left over right %.4f, exact %.4f" % [p, found.x / found.y, expected.x / expected.y])
	gut.p("%s: all over exact %.4f" % [p, (found.x + found.y) / (expected.x + expected.y)])
	assert_gt(expected.x / expected.y, 1.2, "one side is brighter")
	assert_almost_eq((found.x / found.y) / (expected.x / expected.y), 1.0, 0.03, "left over right")
	assert_almost_eq((found.x + found.y) / (expected.x + expected.y), 1.0, 0.03, "light in all")


func test_the_suns_surface_is_the_sun() -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility keeps no linear light")
		return
	# Of 5772 K at the hottest ring, seen from so far that nothing shifts but the ring itself.
	_disk.peak_temperature = 5772.0
	_booth.sky.exposure = EXPOSURE_EV
	var seen := _aim(0.0, LensingTable.MOTION_STATIC, 400.0, 3.0)
	_booth.aim(seen.view)
	var picture := PictureMeasure.of_image(await _booth.take())
	var pixel := seen.pixel_of(4.775, 1.0, 0)
	var redshift: float = seen.seen_at(pixel, 0)["redshift"]
	# A star of magnitude V has 30 10^(-0.4 V) in the reference pixel; the Sun, of V = -26.74, is a
	# disk of 6.79e-5 sr, and such a pixel 1/388800 sr.
	var sun := 30.0 * pow(10.0, 0.4 * 26.74) * (1.0 / 388800.0) / 6.794e-5
	var expected := sun * PlanckLight.shift_factor(5772.0, redshift) * pow(2.0, EXPOSURE_EV)
	assert_almost_eq(picture.sample(pixel) / expected, 1.0, 0.01)


func test_the_exposure_follows_the_disk() -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility keeps no linear light")
		return
	_booth.sky.auto_exposure = true
	_booth.sky.auto_exposure_min_ev = -60.0
	_aim(30.0, LensingTable.MOTION_STATIC, 12.0, 60.0)
	var means := PackedFloat64Array()
	for brightness: float in [-10.0, -20.0]:
		_disk.brightness_ev = brightness
		_booth.sky.adapt_at_once()
		var picture := PictureMeasure.of_image(await _booth.take())
		var sum := 0.0
		for value in picture.luminance:
			sum += value
		means.append(sum / picture.luminance.size())
	gut.p("means %s, %.2f EV" % [means, _booth.sky.get_effective_exposure()])
	assert_almost_eq(means[0] / means[1], 1.0, 0.15, "whatever its brightness")
	assert_between(means[0], 0.5 * KEY, 2.0 * KEY)


func test_an_opaque_disk_hides_the_sky() -> void:
	var measured := await _sky_through_disk(1.0)
	assert_almost_eq(measured.x, 0.0, 1e-4, "behind the disk")
	assert_almost_eq(measured.y, WHITE, 0.02, "beside it")


func test_a_translucent_disk_dims_the_sky() -> void:
	var measured := await _sky_through_disk(0.6)
	# Seen nearly face on: 40 % come through, a little less where light crosses it aslant.
	# Compatibility mixes display values, and comes near.
	var slack := 1.02 if SkyBooth.is_linear() else 1.15
	assert_between(measured.x, 0.85 * 0.4 * WHITE, slack * 0.4 * WHITE, "through the disk")
	assert_almost_eq(measured.y, WHITE, 0.02, "beside it")


func test_a_star_is_hidden_and_dimmed() -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility keeps no linear light")
		return
	_booth.sky.stars_visible = true
	_disk.brightness_ev = -100.0
	var seen := _aim(10.0, LensingTable.MOTION_STATIC, 20.0, 50.0)
	var pixel := seen.pixel_of(9.0, 2.0, 0)
	var sky: Dictionary = seen.view.observer.trace(
		seen.view.place, Vec3D.to_vector3(seen.view.to_direction(pixel))
	)
	_booth.show_stars([sky["sky_direction"]], [2.0])
	var sums := PackedFloat64Array()
	for opacity: float in [0.0, 0.5, 1.0]:
		_disk.opacity = opacity
		sums.append(PictureMeasure.of_image(await _booth.take()).sum_around(pixel, 10.0))
	assert_gt(sums[0], 1.0, "without")
	assert_between(sums[1] / sums[0], 0.42, 0.51, "translucent")
	assert_almost_eq(sums[2] / sums[0], 0.0, 1e-3, "opaque")


func test_scene_geometry_stands_before_and_behind() -> void:
	_disk.look = AccretionDisk.LOOK_CHECKERBOARD
	var seen := _aim(30.0, LensingTable.MOTION_STATIC, 20.0, 60.0)
	var pixel := seen.pixel_of(9.0, 2.0, 0)
	var ball := MeshInstance3D.new()
	ball.mesh = SphereMesh.new()
	ball.material_override = StandardMaterial3D.new()
	ball.material_override.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	ball.material_override.albedo_color = Color.GREEN
	_booth.viewport.add_child(ball)
	var toward := Vec3D.to_vector3(seen.view.to_direction(pixel))
	var greens := PackedFloat64Array()
	for distance: float in [8.0, 60.0]:
		ball.position = seen.view.place + toward * distance
		ball.scale = Vector3.ONE * distance * 0.1
		var colour := (await _booth.take()).get_pixelv(Vector2i(pixel))
		greens.append(colour.g - colour.b)
	assert_gt(greens[0], 0.5, "nearer than the disk")
	assert_lt(greens[1], 0.1, "beyond it")


func test_a_hidden_disk_leaves_no_trace() -> void:
	_booth.sky.panorama = _white()
	_booth.sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	var seen := _aim(60.0, LensingTable.MOTION_STATIC, 10.0, 90.0)
	seen.view.size = Vector2i(320, 180)
	_booth.aim(seen.view)
	var with := (await _booth.take()).get_data()
	_disk.visible = false
	var hidden := (await _booth.take()).get_data()
	_booth.sky.remove_child(_disk)
	var without := (await _booth.take()).get_data()
	_booth.sky.add_child(_disk)
	assert_ne(with, hidden)
	assert_eq(hidden, without)


## Light of a white sky through the disk and beside it.
func _sky_through_disk(opacity: float) -> Vector2:
	_booth.sky.panorama = _white()
	_booth.sky.panorama_luminance = WHITE
	_booth.sky.panorama_is_light = false
	_booth.sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	_disk.brightness_ev = -100.0
	_disk.opacity = opacity
	var seen := _aim(5.0, LensingTable.MOTION_STATIC, 30.0, 70.0)
	var picture := PictureMeasure.of_image(await _booth.take())
	var through := picture.sample(seen.pixel_of(9.0, 2.0, 0))
	return Vector2(through, picture.sample(Vector2(20, 20)))


func _aim(
	inclination: float, motion: LensingTable.Motion, radius: float, vertical_fov_deg: float
) -> DiskView:
	var seen := DiskView.new(radius, inclination, motion, vertical_fov_deg)
	_disk.basis = seen.disk_basis
	_booth.aim(seen.view)
	return seen


func _white() -> Texture2D:
	var image := Image.create_empty(4, 2, false, Image.FORMAT_RGBF)
	image.fill(Color.WHITE)
	return ImageTexture.create_from_image(image)
