# SPDX-License-Identifier: MIT
extends GutTest
## Turbulence of the disk in time: carried along by the orbits, never popping, of an even contrast;
## and the disk is right in every eye of the same frame.

const LIFETIME: float = 40.0
## Times of one sweep, over two lifetimes.
const STEPS: int = 32

var _booth: SkyBooth
var _disk: AccretionDisk

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_each() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_booth.sky.exposure = -36.0
	_disk = AccretionDisk.new()
	_disk.look = AccretionDisk.LOOK_TURBULENT
	_disk.eddy_lifetime = LIFETIME
	_disk.outer_fade = 0.0
	_booth.sky.add_child(_disk)
	add_child(_booth)


func after_each() -> void:
	_booth.free()


func test_brightness_goes_on_evenly() -> void:
	_aim(20.0, 60.0)
	var before := await _measure()
	var typical := 0.0
	var largest := 0.0
	var least_mean := INF
	var most_mean := 0.0
	for i in STEPS:
		_disk.time += 2.0 * LIFETIME / STEPS
		var after := await _measure()
		var change := _change(before, after)
		typical += change / STEPS
		largest = maxf(largest, change)
		var mean := _mean(after)
		least_mean = minf(least_mean, mean)
		most_mean = maxf(most_mean, mean)
		before = after
	gut.p("change from step to step %.3f, at most %.3f" % [typical, largest])
	gut.p("mean %.3f to %.3f" % [least_mean, most_mean])
	assert_gt(typical, 0.02, "it moves")
	assert_lt(largest, 1.4 * typical, "no step stands out")
	assert_lt(most_mean / least_mean, 1.15, "the light in all stays")


func test_small_times_change_little() -> void:
	_aim(20.0, 60.0)
	# Next to where a generation begins at the eye, and far from it.
	for time: float in [0.0, 0.5 * LIFETIME, 13.7]:
		_disk.time = time - 0.01
		var before := await _measure()
		_disk.time = time + 0.01
		assert_lt(_change(before, await _measure()), 0.02, "at %f" % time)


func test_eddies_go_round_with_the_orbits() -> void:
	# Face on from afar: a ring of the picture is a circle of the disk.
	var radius := 10.0
	var seen := _aim(100.0, 0.5)
	seen.view.vertical_fov_deg = 20.0
	_booth.aim(seen.view)
	for retrograde: bool in [false, true]:
		_disk.retrograde = retrograde
		# Mid-life of one generation, where its eddies are alone.
		var start := await _ring(seen, radius, 0.42)
		var later := await _ring(seen, radius, 0.58)
		var turn := TAU * 0.16 * LIFETIME / AccretionDisk.orbital_period(radius)
		var expected := -turn if retrograde else turn
		var best := 0.0
		var most := -INF
		for step in range(-90, 91):
			var shift := step / 90.0 * 0.6
			var alike := _correlation(start, later, shift)
			if alike > most:
				most = alike
				best = shift
		gut.p("turned %.3f rad, the orbit %.3f, correlation %.2f" % [best, expected, most])
		assert_almost_eq(best, expected, 0.06)
		assert_gt(most, 0.5)


func test_every_eye_of_a_frame_is_right() -> void:
	_disk.look = AccretionDisk.LOOK_CHECKERBOARD
	var near := _aim(8.0, 50.0)
	var far := DiskView.new(30.0, 75.0, LensingTable.MOTION_STATIC, 40.0)
	var other := SubViewport.new()
	other.size = far.view.size
	other.use_hdr_2d = _booth.viewport.use_hdr_2d
	other.world_3d = _booth.viewport.find_world_3d()
	var camera := Camera3D.new()
	camera.set_perspective(far.view.vertical_fov_deg, 0.05, 4000.0)
	camera.transform = far.view.camera_transform(1.0)
	other.add_child(camera)
	_booth.add_child(other)
	other.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var alone := await _booth.take()
	var together := other.get_texture().get_image()
	_booth.aim(far.view)
	var expected := await _booth.take()
	assert_ne(alone.get_data(), together.get_data())
	assert_eq(together.get_data(), expected.get_data())
	assert_gt(near.view.place.distance_to(far.view.place), 5.0)


func _aim(radius: float, inclination: float) -> DiskView:
	var seen := DiskView.new(radius, inclination, LensingTable.MOTION_STATIC, 60.0)
	seen.view.size = Vector2i(320, 180)
	_disk.basis = seen.disk_basis
	_booth.aim(seen.view)
	return seen


func _measure() -> PackedFloat32Array:
	return PictureMeasure.of_image(await _booth.take()).luminance


func _mean(luminance: PackedFloat32Array) -> float:
	var sum := 0.0
	for value in luminance:
		sum += value
	return sum / luminance.size()


## Mean absolute difference over the mean.
func _change(a: PackedFloat32Array, b: PackedFloat32Array) -> float:
	var sum := 0.0
	for i in a.size():
		sum += absf(a[i] - b[i])
	return sum / a.size() / maxf(_mean(a), 1e-9)


## Light round a circle of the disk, less its slow changes, at a part of the second generation's
## life when seen.
func _ring(seen: DiskView, radius: float, part: float) -> PackedFloat32Array:
	_disk.time = (20.0 + part) * LIFETIME + seen.view.place.length()
	var picture := PictureMeasure.of_image(await _booth.take())
	var light := PackedFloat32Array()
	for i in 360:
		light.append(picture.sample(seen.pixel_of(radius, TAU * i / 360.0, 0)))
	return light


## Of the second ring, turned back by `turn`, with the first.
func _correlation(a: PackedFloat32Array, b: PackedFloat32Array, turn: float) -> float:
	var turned := PackedFloat32Array()
	for i in a.size():
		var at := fposmod(i + turn * a.size() / TAU, a.size())
		var lower := int(at)
		turned.append(lerpf(b[lower % b.size()], b[(lower + 1) % b.size()], at - lower))
	return PictureMeasure.correlation_of(a, turned)
