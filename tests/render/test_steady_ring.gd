# SPDX-License-Identifier: MIT
extends GutTest
## The panorama does not shimmer where the hole bends it most: round the Einstein ring and along the
## shadow's edge, while the camera turns by a twentieth of a pixel a frame.
##
## ShimmerBand says what is measured. What is left at the Einstein ring are the kinks between
## texels, where linear interpolation changes its slope: between them a pixel's luminance goes in
## straight lines.

const STEP_PX: float = 0.05
const FRAMES: int = 24
const ALL_FRAMES: int = 60
const SIZE := Vector2i(640, 360)
## So small that a pixel on the ring holds ten texels.
const SMALL := Vector2i(160, 90)
## The ring, 60 degrees wide, fills the picture's height.
const VERTICAL_FOV_DEG: float = 68.0
## Of all pixels and frames, so many stay below the limit.
const SHARE: float = 0.999
## From peak to peak; measured: 0.27 % at most.
const MOST_LIGHT: float = 0.005
## Numbers of 32 bits that hold the grey texels of 2048 x 1024.
const NOISE_WORDS: int = 524288
const ROOM_OF_NOISE: String = """
	vec3 cell = floor(direction * 330.0);
	return vec3(fract(sin(dot(cell, vec3(12.9898, 78.233, 37.719))) * 43758.5453));
"""
const PLACE := Vector3(0.55, 4.83, -8.74)

var _booth: SkyBooth

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_booth.sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_booth.sky.panorama_is_light = false
	_booth.sky.panorama_luminance = 1.0
	_booth.sky.exposure = 0.0


func test_the_milky_way_is_steady() -> void:
	_booth.sky.panorama = load(MilkyWay.FILE) as Texture2D
	_booth.sky.panorama_luminance = MilkyWay.LUMINANCE
	_booth.sky.panorama_is_light = true
	# Half floats have fewer digits below 6e-5.
	_booth.sky.exposure = 6.0
	# Measured: 4.4 % and 12.9 %; with sparks at the edge, of single pixels in single frames, 180 %.
	await _judge("Milky Way", 0.08, 0.2)


func test_noise_is_steady() -> void:
	_booth.sky.panorama = _noise(true)
	# Measured: 17.1 % and 4.7 %.
	await _judge("noise", 0.2, 0.07)


## The same in a cube map and in captured surroundings, where the filter is our own.
func test_noise_is_steady_in_cube_maps_and_surroundings() -> void:
	if not RendererScope.is_everything_wanted():
		pending("a long test, for ./test --all")
		return
	_booth.sky.cubemap = _noise_cube()
	_booth.sky.background = BlackHoleSky.BACKGROUND_CUBEMAP
	await _judge("noise in a cube map", 0.2, 0.07)
	var capture := SurroundingsCapture.new()
	_booth.camera.cull_mask = 1
	_booth.sky.add_child(capture)
	_booth.viewport.add_child(TestRoom.make(ROOM_OF_NOISE))
	_booth.sky.background = BlackHoleSky.BACKGROUND_SURROUNDINGS
	await _judge("noise in the surroundings", 0.2, 0.07)
	_booth.sky.background = BlackHoleSky.BACKGROUND_PANORAMA


## Without smaller copies of the panorama for its filter, the noise shimmers. Measured: 21 % and 5 %
## with them, 110 % and 145 % without.
func test_the_measure_sees_shimmer() -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility's eight bits are coarser than the measure")
		return
	_booth.sky.panorama = _noise(true)
	var steady := await _turn("noise, small picture", SMALL)
	_booth.sky.panorama = _noise(false)
	var shimmering := await _turn("the same without mipmaps", SMALL)
	for i in steady.size():
		var most := steady[i].second_difference(SHARE)
		assert_gt(shimmering[i].second_difference(SHARE), 2.0 * most)


## With the limits of the second differences round the Einstein ring and along the shadow's edge.
func _judge(whose: String, most_at_ring: float, most_at_edge: float) -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility's eight bits are coarser than the measure")
		return
	var bands := await _turn(whose)
	assert_lt(bands[0].second_difference(SHARE), most_at_ring, "Einstein ring")
	assert_lt(bands[1].second_difference(SHARE), most_at_edge, "shadow edge")
	for band in bands:
		assert_gt(band.pixel_count(), 2000, "pixels measured")
		assert_lt(band.light_change(), MOST_LIGHT, "the band's light")


## Films the turning camera: the band round the ring and that along the shadow's edge.
func _turn(whose: String, size: Vector2i = SIZE) -> Array[ShimmerBand]:
	var frames := ALL_FRAMES if RendererScope.is_everything_wanted() else FRAMES
	var first := _view(-0.5 * (frames - 1), size)
	var last := _view(0.5 * (frames - 1), size)
	var pixel := 1.0 / first.focal()
	var ring: float = first.observer.star_image(PLACE, -PLACE.normalized(), 0)["xi"]
	var shadow := first.shadow_half_angle()
	var bands: Array[ShimmerBand] = [
		ShimmerBand.new(ring - 12.0 * pixel, ring + 12.0 * pixel, first, last),
		# Beyond the pixel over which the edge is blended; the second ring is in it.
		ShimmerBand.new(shadow + 1.0 * pixel, shadow + 9.0 * pixel, first, last),
	]
	for frame in frames:
		var view := _view(frame - 0.5 * (frames - 1), size)
		_booth.aim(view)
		var picture: Image = await _booth.take()
		for band in bands:
			band.add(picture, view)
	var names: PackedStringArray = ["Einstein ring", "shadow edge"]
	for i in bands.size():
		var differences := 100.0 * bands[i].second_difference(SHARE)
		var text := "%s, %s: %d pixels, second differences %.3f %%, light %.3f %%"
		var light := 100.0 * bands[i].light_change()
		gut.p(text % [whose, names[i], bands[i].pixel_count(), differences, light])
	return bands


## The camera so many steps from looking straight at the hole.
func _view(steps: float, size: Vector2i) -> ExactView:
	var view := ExactView.new(PLACE, LensingTable.MOTION_STATIC)
	view.size = size
	view.vertical_fov_deg = VERTICAL_FOV_DEG
	var angle := steps * STEP_PX / view.focal()
	var aside := ExactView.sum(view.right, 0.8, view.up, 0.6)
	var upward := Vec3D.to_vector3(view.up)
	view.look_along(ExactView.sum(view.forward, cos(angle), aside, sin(angle)), upward)
	return view


## Texels of any grey between black and white, each by itself.
static func _noise(with_mipmaps: bool) -> ImageTexture:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	var numbers: PackedInt32Array = []
	for i in NOISE_WORDS:
		numbers.append(rng.randi())
	var bytes := numbers.to_byte_array()
	var image := Image.create_from_data(2048, 1024, false, Image.FORMAT_L8, bytes)
	image.convert(Image.FORMAT_RGBF)
	if with_mipmaps:
		image.generate_mipmaps()
	return ImageTexture.create_from_image(image)


## The same on the faces of a cube, of which each texel is as large.
static func _noise_cube() -> Cubemap:
	var rng := RandomNumberGenerator.new()
	rng.seed = 6
	var faces: Array[Image] = []
	for face in 6:
		var numbers: PackedInt32Array = []
		for i in 65536:
			numbers.append(rng.randi())
		var bytes := numbers.to_byte_array()
		var image := Image.create_from_data(512, 512, false, Image.FORMAT_L8, bytes)
		image.convert(Image.FORMAT_RGBF)
		image.generate_mipmaps()
		faces.append(image)
	var cubemap := Cubemap.new()
	cubemap.create_from_images(faces)
	return cubemap
