# SPDX-License-Identifier: MIT
extends GutTest
## Stars do not twinkle when the camera turns slowly: each one's summed luminance, against what its
## pixels' solid angle asks for, varies by 2 % at most from peak to peak.

const STEP_PX: float = 0.05
const FRAMES: int = 24
const ALL_FRAMES: int = 120
const MOST: float = 0.02
## Light of stars that are plain to see, and of others a few times as bright as the faint limit.
const BRIGHT: float = 2.0
const FAINT: float = 0.004

var _booth: SkyBooth
var _rng := RandomNumberGenerator.new()

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_booth = SkyBooth.new()
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func test_turning_camera(
	# model, light of a star, pixels to measure round it
	p: Array = use_parameters(
		[
			[BlackHoleSky.PSF_GAUSSIAN, BRIGHT, 7],
			[BlackHoleSky.PSF_GAUSSIAN, FAINT, 5],
			[BlackHoleSky.PSF_AIRY, BRIGHT, 24],
			[BlackHoleSky.PSF_AIRY, FAINT, 6],
			[BlackHoleSky.PSF_EYE, BRIGHT, 38],
			[BlackHoleSky.PSF_EYE, FAINT, 6],
		]
	)
) -> void:
	if not SkyBooth.is_linear() and p[1] == FAINT:
		p[1] = 0.3  # 8 bits show no fainter ones
	_rng.seed = 11
	_booth.sky.psf_model = p[0]
	_booth.sky.psf_sigma = 1.0
	_booth.sky.aperture_mm = 1.0
	var radius: int = p[2]
	var view := ExactView.new(Vector3(2, 6, -5), LensingTable.MOTION_STATIC)
	view.size = Vector2i(640, 480)
	view.look_beside(0.35, Vector3(1, 2, 0.5))
	var field := _field(view, p[1], 2.0 * radius)
	_booth.sky.catalogue = field.catalogue()
	var lights: Array[PackedFloat64Array] = []
	for target in field.targets:
		lights.append(PackedFloat64Array())
	var start := view.forward
	for frame in ALL_FRAMES if RendererScope.is_everything_wanted() else FRAMES:
		var angle := frame * STEP_PX / view.focal()
		var aside := ExactView.sum(view.right, 0.8, view.up, 0.6)
		var forward := ExactView.sum(start, cos(angle), aside, sin(angle))
		var turned := ExactView.new(view.place, LensingTable.MOTION_STATIC)
		turned.size = view.size
		turned.look_along(forward, Vec3D.to_vector3(view.up))
		_booth.aim(turned)
		var picture: Image = await _booth.take()
		for i in field.targets.size():
			var direction := view.to_direction(field.targets[i].pixel)
			var pixel := turned.to_pixel(direction)
			var wanted := turned.flat_luminance_sum(pixel)
			lights[i].append(PicturePatch.light(picture, pixel, radius) / wanted)
	_judge(p, lights)


## Stars near the ring, of both orders, and others.
func _field(view: ExactView, light: float, apart: float) -> StarField:
	var field := StarField.new(view, _rng, light, apart)
	var behind := Vec3D.scaled(view.outward(), -1.0)
	for step in 16:
		var side := ExactView.across(ExactView.doubled(Vector3(_rng.randfn(), 1, 0)), behind)
		var star := Vec3D.to_vector3(ExactView.sum(behind, cos(0.04), side, sin(0.04)))
		field.add_at(view.star_spot(star, step % 2).pixel)
	var magnified := 0
	for i in field.targets.size():
		var spot := view.star_spot(field.directions[i], field.targets[i].order)
		magnified += 1 if spot.magnification > 3.0 else 0
	assert_gte(magnified, 2, "magnified stars")
	field.add(1, 2, 1000)
	field.add(0, 5, 1000)
	return field


func _judge(p: Array, lights: Array[PackedFloat64Array]) -> void:
	var worst := 0.0
	for light in lights:
		var sorted := light.duplicate()
		sorted.sort()
		worst = maxf(worst, (sorted[-1] - sorted[0]) / sorted[0] if sorted[0] > 0.0 else INF)
	gut.p("%s: %d stars vary by %.3f %%" % [p, lights.size(), 100.0 * worst])
	assert_gte(lights.size(), 7, "stars measured")
	assert_lt(worst, MOST if SkyBooth.is_linear() else 2.0 * MOST, "peak to peak")
