# SPDX-License-Identifier: MIT
extends GutTest
## Captures without the hole: stars stand where special relativity's aberration puts them, as bright
## as its Doppler effect makes them.

const LIGHT: float = 1.5
const SEEN_KELVIN: float = 6500.0

var _folder := ScratchFolder.new("capture_flight")

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func test_a_flight_without_the_hole(
	# how the eye moves; its velocity
	p: Array = use_parameters(
		[
			["static", Vector3.ZERO],
			[{"motion": "velocity", "beta": [0.48, 0, -0.64]}, Vector3(0.48, 0.0, -0.64)],
			[
				{"motion": "velocity", "celerity": [0, 0, 0.75], "relative_to": "static"},
				Vector3(0, 0, 0.6)
			],
		]
	)
) -> void:
	# Where only rain could be if there were a hole.
	var view := ExactView.new(Vector3(0, 0, 0.5), LensingTable.MOTION_RAIN)
	view.size = Vector2i(640, 360)
	view.look_along(ExactView.doubled(Vector3(0.9, 0.3, -0.5)), Vector3.UP)
	var pixels: PackedVector2Array = []
	var stars: PackedVector3Array = []
	var magnitudes: PackedFloat32Array = []
	var kelvins: PackedFloat32Array = []
	for column in 4:
		for row in 3:
			var pixel := Vector2(60.3 + 170.4 * column, 40.7 + 133.2 * row)
			var seen := Vec3D.to_vector3(view.to_direction(pixel))
			var g := _doppler(seen, p[1])
			var kelvin := SEEN_KELVIN / g
			# The solid angle goes with 1/g^2.
			var factor := PlanckLight.shift_factor(kelvin, g) / (g * g)
			var flux := LIGHT / (view.flat_luminance_sum(pixel) * factor)
			pixels.append(pixel)
			stars.append(_at_rest(seen, p[1]))
			magnitudes.append(-2.5 * log(flux) / log(10.0))
			kelvins.append(kelvin)
	var catalogue := _folder.write_text("stars.csv", StarCsv.text(stars, magnitudes, kelvins))
	var picture := await _take(
		{
			"hole": false,
			"resolution": [640, 360],
			"position_rs": [0, 0, 0.5],
			"look_at_rs": [0.9, 0.3, 0],
			"observer": p[0],
			"stars": {"catalogue": catalogue, "magnitude_limit": 99},
		}
	)
	var worst := 0.0
	var worst_light := 0.0
	for pixel in pixels:
		worst = maxf(worst, PicturePatch.centroid(picture, pixel).distance_to(pixel))
		worst_light = maxf(worst_light, absf(PicturePatch.light(picture, pixel, 7) / LIGHT - 1.0))
	gut.p("%s: worst %.4f px, light %.2f %%" % [p[0], worst, 100.0 * worst_light])
	assert_lt(worst, 0.05 if SkyBooth.is_linear() else 0.08, "place")
	assert_lt(worst_light, 0.02, "light")


func _take(data: Dictionary) -> Image:
	var stage := ShotStage.new()
	add_child_autofree(stage)
	var spec := ShotSpec.from_data(data)
	assert_eq(spec.error, "", "the shot is fine")
	var refusal: PackedStringArray = []
	var picture: Image = await stage.take(spec, refusal)
	assert_eq(refusal, PackedStringArray(), "the shot is taken")
	return picture


## By how much light seen from a direction is shifted for who moves with `beta`.
static func _doppler(seen: Vector3, beta: Vector3) -> float:
	return sqrt(1.0 - beta.length_squared()) / (1.0 - beta.dot(seen))


## Where that light comes from for who is at rest.
static func _at_rest(seen: Vector3, beta: Vector3) -> Vector3:
	var gamma := 1.0 / sqrt(1.0 - beta.length_squared())
	# (gamma - 1) / beta^2 without the division by 0.
	var part := gamma * gamma / (gamma + 1.0)
	return (_doppler(seen, beta) * (seen + beta * (part * seen.dot(beta) - gamma))).normalized()
