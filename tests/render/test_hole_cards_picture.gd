# SPDX-License-Identifier: MIT
extends GutTest
## The cards as they are drawn: words on dark panels beside a shadow that stays black, also where a
## headset has few pixels.

const HOLE := Vector3(0.0, 1.5, -1.5)

var _booth: SkyBooth
var _cards: HoleCards

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_booth.sky.schwarzschild_radius = 0.3
	_booth.sky.position = HOLE
	_booth.camera.position = Vector3(0.0, 1.5, 0.0)
	_booth.camera.set_perspective(80.0, 0.01, 4000.0)
	add_child(_booth)
	_cards = HoleCards.new()
	_cards.sky = _booth.sky
	_cards.head = _booth.camera
	_booth.viewport.add_child(_cards)


func after_all() -> void:
	_booth.free()


func test_words_are_bright_on_dark_panels(
	size: Vector2i = use_parameters([Vector2i(640, 480), Vector2i(320, 240)])
) -> void:
	_booth.viewport.size = size
	_cards.open(HoleCards.Subject.PHOTON_SPHERE)
	await wait_process_frames(3)
	for i in 60:
		_cards._process(0.1)
	var picture := await _booth.take()
	var on_card := _rows_of_light(picture, _cards.get_card(HoleCards.Subject.PHOTON_SPHERE))
	var brightest := 0.0
	var lit := 0
	for value in on_card:
		brightest = maxf(brightest, value)
		lit += 1 if value > 0.2 else 0
	assert_gt(brightest, 0.6, "white letters")
	var share := float(lit) / on_card.size()
	gut.p("%s: %.3f of the card is lit, brightest %.2f" % [size, share, brightest])
	assert_between(share, 0.05, 0.3, "letters, and room between them")


func test_the_shadow_stays_black() -> void:
	_booth.viewport.size = Vector2i(640, 480)
	_cards.open(HoleCards.Subject.EINSTEIN_RING)
	await wait_process_frames(3)
	for i in 60:
		_cards._process(0.1)
	var picture := PictureMeasure.of_image(await _booth.take())
	var centre := Vector2(0.5 * picture.width, 0.5 * picture.height)
	var focal := 0.5 * picture.height / tan(deg_to_rad(40.0))
	var shadow: float = SkyObserver.new().shadow(Vector3(0.0, 0.0, 5.0))["half_angle"]
	var radius := focal * tan(shadow) - 8.0
	var lit := 0
	var all := 0
	for y in picture.height:
		for x in picture.width:
			if centre.distance_to(Vector2(x, y)) < radius:
				all += 1
				lit += 1 if picture.at(x, y) > 1e-3 else 0
	# The leader to its middle, and no more.
	assert_between(float(lit) / all, 1e-4, 0.01)


## Luminances on a card's inner part.
func _rows_of_light(picture: Image, card: HoleCard) -> PackedFloat32Array:
	var found: PackedFloat32Array = []
	var measure := PictureMeasure.of_image(picture)
	for y in measure.height:
		for x in measure.width:
			var at := Vector2(x + 0.5, y + 0.5)
			var from := _booth.camera.project_ray_origin(at)
			var along := card.distance_along(from, _booth.camera.project_ray_normal(at))
			if along == INF:
				continue
			var on_it := (
				card.global_transform.affine_inverse()
				* (from + along * _booth.camera.project_ray_normal(at))
			)
			var inner := 0.46 * card.get_size()
			if absf(on_it.x) < inner.x and absf(on_it.y) < inner.y:
				found.append(measure.at(x, y))
	return found
