# SPDX-License-Identifier: MIT
extends RigCase
## No ride flickers: within a second the picture's mean luminance does not swing to and fro by more
## than a tenth more than three times, with the stars, the Milky Way and the limit of brightness of
## the scene for headsets. Measured on pictures of the whole ride with ./test --all and Mobile, of
## parts of it otherwise.

const SIZE := Vector2i(160, 120)
const PICTURES_PER_SECOND: int = 12
const SWING: float = 0.1
const MOST_SWINGS: int = 3
const EXPOSURE: float = 1.5
## Below this mean luminance nothing can be seen to swing.
const DARK: float = 2e-4

var _viewport: SubViewport
var _camera: Camera3D
var _rides: XrRides

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_each() -> void:
	super()
	comfort.blinks = false
	_viewport = SubViewport.new()
	_viewport.size = SIZE
	_viewport.use_hdr_2d = true
	_viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	_camera = Camera3D.new()
	_camera.fov = 80.0
	_camera.near = 0.01
	_viewport.add_child(_camera)
	put(_viewport)
	sky.exposure = EXPOSURE
	var data := SkyData.new()
	data.sky = sky
	put(data)
	data.load_all()
	var limit := BrightnessLimit.new()
	limit.sky = sky
	limit.head = head
	put(limit)
	_rides = XrRides.new()
	_rides.rig = rig
	_rides.sky = sky
	_rides.countdown_seconds = 0
	put(_rides)
	_rides.set_process(false)


func test_rides(
	kind: XrRides.Kind = use_parameters([XrRides.Kind.FALL, XrRides.Kind.ORBIT_RIGHT])
) -> void:
	_rides.start(kind)
	_rides.advance(0.001)
	var most := 0
	var pictures := 0
	for part: Vector2 in _parts(kind):
		if part.x > 0.0 and _rides.ride.is_reversible():
			_rides.ride.seek(part.x)
		var luminances: PackedFloat32Array = []
		for i in roundi(part.y * PICTURES_PER_SECOND):
			if not _rides.is_on():
				break
			_rides.advance(1.0 / PICTURES_PER_SECOND)
			luminances.append(await _mean_luminance())
		pictures += luminances.size()
		most = maxi(most, _most_swings(luminances))
	gut.p("%d pictures, at most %d swings a second" % [pictures, most])
	assert_gt(pictures, 20)
	assert_lte(most, MOST_SWINGS)


func test_swings_are_counted() -> void:
	var steady: PackedFloat32Array = []
	var flickering: PackedFloat32Array = []
	for i in 24:
		steady.append(0.1 + 0.004 * i)
		flickering.append(0.1 if i % 2 == 0 else 0.13)
	assert_eq(_most_swings(steady), 1, "one long rise")
	assert_gt(_most_swings(flickering), 8)


# Where along a ride (0: where it is) pictures are taken, and for how many seconds.
func _parts(kind: XrRides.Kind) -> Array[Vector2]:
	var by_mobile := RenderingServer.get_current_rendering_method() == "mobile"
	if RendererScope.is_everything_wanted() and by_mobile:
		return [Vector2(0.0, 60.0 if kind == XrRides.Kind.FALL else 20.0)]
	if kind == XrRides.Kind.ORBIT_RIGHT:
		return [Vector2(0.0, 2.0)]
	return [Vector2(0.5, 1.2), Vector2(0.75, 1.2), Vector2(0.93, 1.2)]


func _mean_luminance() -> float:
	_camera.global_transform = head.global_transform
	await RenderingServer.frame_post_draw
	var picture := _viewport.get_texture().get_image()
	picture.convert(Image.FORMAT_RGBAF)
	picture.resize(1, 1, Image.INTERPOLATE_TRILINEAR)
	return picture.get_pixel(0, 0).get_luminance()


# The most changes of direction within a second, of changes by more than a tenth.
func _most_swings(luminances: PackedFloat32Array) -> int:
	var times: PackedFloat32Array = []
	var from := luminances[0] if not luminances.is_empty() else 0.0
	var direction := 0
	for i in luminances.size():
		var now := luminances[i]
		var change := (now - from) / maxf(maxf(now, from), DARK)
		if absf(change) > SWING and signi(roundi(signf(change))) != direction:
			direction = signi(roundi(signf(change)))
			times.append(float(i) / PICTURES_PER_SECOND)
			from = now
		elif direction == 0 and absf(change) <= SWING:
			continue
		elif signf(now - from) == float(direction):
			from = now
	var most := 0
	for i in times.size():
		var within := 0
		for time in times:
			within += 1 if time >= times[i] and time < times[i] + 1.0 else 0
		most = maxi(most, within)
	return most
