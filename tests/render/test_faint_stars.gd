# SPDX-License-Identifier: MIT
extends GutTest
## Light too faint for one step of an 8-bit picture still adds up.

const STARS: int = 20
## Peak of one star with a sprite of one pixel: 0.0008, a fifth of an 8-bit step in linear light.
const LIGHT: float = 0.005


func test_twenty_stars_on_one_spot() -> void:
	if not SkyBooth.is_linear():
		pending(
			"the Compatibility renderer blends 8 bits of sRGB: faint light does not add up there"
		)
		return
	var booth := SkyBooth.new()
	add_child_autofree(booth)
	booth.sky.image_orders = 1
	var view := ExactView.new(Vector3(3, 2, -4), LensingTable.MOTION_STATIC)
	view.look_beside(1.3, Vector3(1, 2, 0.5))
	var rng := RandomNumberGenerator.new()
	var field := StarField.new(view, rng, LIGHT)
	var pixel := Vector2(700.3, 400.8)
	assert_true(field.add_at(pixel), "there is a place for the star")
	var directions := PackedVector3Array()
	var magnitudes := PackedFloat32Array()
	var kelvins := PackedFloat32Array()
	for i in STARS:
		directions.append(field.directions[0])
		magnitudes.append(field.magnitudes[0])
		kelvins.append(field.temperatures[0])
	booth.show_stars(directions, magnitudes, kelvins)
	booth.aim(view)
	var picture: Image = await booth.take()
	var light := PicturePatch.light(picture, pixel, 7)
	gut.p("%.5f of %.5f" % [light, STARS * LIGHT])
	assert_almost_eq(light, STARS * LIGHT, 0.02 * STARS * LIGHT, "twenty faint stars")
	booth.show_stars(directions.slice(0, 1), magnitudes.slice(0, 1), kelvins.slice(0, 1))
	picture = await booth.take()
	light = PicturePatch.light(picture, pixel, 7)
	assert_almost_eq(light, LIGHT, 0.05 * LIGHT, "one of them alone")
