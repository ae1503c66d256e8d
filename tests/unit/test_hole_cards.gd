# SPDX-License-Identifier: MIT
extends GutTest
## The cards beside the hole: legible, beside the shadow and each other, and right about where
## things are seen.

const HOLE := Vector3(0.3, 1.5, -2.0)
const SAMPLES: int = 12
const LANGUAGES: PackedStringArray = ["en", "de"]

var _sky: BlackHoleSky
var _head: Node3D
var _cards: HoleCards
var _languages: Languages
var _locale: String


func before_each() -> void:
	_locale = TranslationServer.get_locale()
	TranslationServer.set_locale("en")
	_languages = Languages.new()
	_sky = BlackHoleSky.new()
	_sky.position = HOLE
	_sky.rotation = Vector3(0.4, 1.0, 0.2)
	_sky.schwarzschild_radius = 0.3
	_head = Node3D.new()
	_cards = HoleCards.new()
	_cards.sky = _sky
	_cards.head = _head
	for node: Node in [_languages, _sky, _head]:
		add_child_autofree(node)
	_stand(5.0)
	add_child_autofree(_cards)
	_cards.set_process(false)


func after_each() -> void:
	TranslationServer.set_locale(_locale)


func test_lines_are_as_high_as_asked_for(r: float = use_parameters([2.5, 5.0, 40.0])) -> void:
	_stand(r)
	_let_pass(0.1)
	for i in 3:
		var card := _cards.get_card(i)
		var words: SubViewport = card.get_node("Words")
		var label: Label = words.get_node("Title")
		var line := label.get_theme_font(&"font").get_height(
			label.get_theme_font_size(&"font_size")
		)
		var height := line / words.size.y * card.get_size().y * card.global_basis.get_scale().y
		var away := card.global_position.distance_to(_head.global_position)
		assert_almost_eq(rad_to_deg(2.0 * atan(0.5 * height / away)), 2.6, 0.01)


func test_texts_fit_their_panels_in_every_language() -> void:
	for language in LANGUAGES:
		TranslationServer.set_locale(language)
		for i in 3:
			_cards.open(i)
			await wait_process_frames(1)
			for other in 3:
				_assert_fits(_cards.get_card(other), language)


func test_they_leave_the_shadow_and_each_other_free(
	r: float = use_parameters([2.2, 3.0, 5.0, 9.0, 30.0, 300.0])
) -> void:
	for language in LANGUAGES:
		TranslationServer.set_locale(language)
		_stand(r)
		for open in 3:
			_cards.open(open)
			_let_pass(3.0)
			assert_true(_cards.has_room())
			var shadow := _shadow()
			var direction: Vector3 = shadow["direction"]
			var nearest := INF
			var overlaps := 0
			for i in 3:
				for point in _points_of(_cards.get_card(i)):
					var seen := (point - _head.global_position).normalized()
					nearest = minf(nearest, direction.angle_to(seen))
					overlaps += _hits(seen, i)
			var half: float = shadow["half_angle"]
			assert_gt(rad_to_deg(nearest - half), 1.0, "beside the shadow, %d open" % open)
			assert_lt(rad_to_deg(nearest - half), 14.0, "but not far from it")
			assert_eq(overlaps, 0, "beside each other, %d open" % open)


func test_leaders_lead_to_what_is_meant(
	motion: LensingTable.Motion = use_parameters(
		[LensingTable.MOTION_STATIC, LensingTable.MOTION_RAIN, LensingTable.MOTION_ORBIT]
	)
) -> void:
	_sky.observer = SkyObserver.new()
	_sky.observer.motion = motion
	_sky.observer.axis = Vector3(0.3, 1.0, 0.1)
	_stand(6.0)
	_let_pass(3.0)
	var shadow := _shadow()
	var middle: Vector3 = shadow["direction"]
	var half: float = shadow["half_angle"]
	var edge := _seen(_cards.get_tip(HoleCards.Subject.PHOTON_SPHERE))
	assert_almost_eq(edge.angle_to(middle), half, 1e-3, "the shadow's edge")
	assert_lt(_seen(_cards.get_tip(HoleCards.Subject.HORIZON)).angle_to(middle), 1e-3)
	var axes := _sky.global_basis.orthonormalized()
	var place := _place()
	var ring := axes.inverse() * _seen(_cards.get_tip(HoleCards.Subject.EINSTEIN_RING))
	var ray := _sky.observer.trace(place, ring)
	assert_false(ray["captured"])
	var behind: Vector3 = ray["sky_direction"]
	assert_lt(behind.angle_to(-place), 0.01, "straight behind the hole")


func test_tips_are_not_behind_their_cards(r: float = use_parameters([3.0, 5.0, 9.0])) -> void:
	_stand(r)
	for open in 3:
		_cards.open(open)
		_let_pass(3.0)
		for i in 3:
			var tip := _seen(_cards.get_tip(i))
			assert_eq(_cards.get_card(i).distance_along(_head.global_position, tip), INF)


func test_they_turn_to_the_head_when_it_has_gone_round() -> void:
	_let_pass(3.0)
	var before := _cards.get_card(0).global_transform
	_stand(5.0, deg_to_rad(20.0))
	_let_pass(3.0)
	assert_true(_cards.get_card(0).global_transform.is_equal_approx(before), "not for 20 degrees")
	_stand(5.0, deg_to_rad(30.0))
	_cards._process(0.02)
	var moved := _cards.get_card(0).global_position.distance_to(before.origin)
	assert_between(moved, 1e-3, 0.25, "gently")
	_let_pass(4.0)
	var card := _cards.get_card(0)
	assert_gt(card.global_position.distance_to(before.origin), 0.3)
	var to_head := card.global_position.direction_to(_head.global_position)
	assert_gt(card.global_basis.z.normalized().dot(to_head), 0.999, "turned to the head")


func test_they_come_along_when_the_distance_changes() -> void:
	_let_pass(3.0)
	var before := _cards.get_card(0).global_transform
	_stand(5.9)
	_let_pass(3.0)
	assert_true(_cards.get_card(0).global_transform.is_equal_approx(before), "not for 18 %")
	_stand(6.5)
	_let_pass(4.0)
	assert_false(_cards.get_card(0).global_transform.is_equal_approx(before), "for 30 %")


func test_one_is_open_at_a_time() -> void:
	watch_signals(_cards)
	_cards.open(HoleCards.Subject.HORIZON)
	assert_signal_emitted_with_parameters(_cards, "opened", [HoleCards.Subject.HORIZON])
	assert_eq(_open_cards(), [HoleCards.Subject.HORIZON])
	_cards.open_next()
	assert_eq(_open_cards(), [HoleCards.Subject.PHOTON_SPHERE])
	_cards.open(-1)
	assert_eq(_open_cards(), [])


func test_tags_can_be_pointed_at_and_chosen() -> void:
	_let_pass(0.1)
	var card := _cards.get_card(HoleCards.Subject.HORIZON)
	var eye := _head.global_position
	var at := card.global_position
	assert_almost_eq(card.distance_along(eye, eye.direction_to(at)), eye.distance_to(at), 1e-4)
	assert_eq(card.distance_along(eye, at.direction_to(eye)), INF, "behind one")
	assert_eq(card.distance_along(eye, eye.direction_to(HOLE)), INF, "beside it")
	assert_null(card.what_is_pointed_at())
	card.point_at(at)
	assert_eq(card.what_is_pointed_at(), card)
	assert_almost_eq(card.dwell_seconds(), 1.2, 1e-6)
	assert_true(card.choose())
	assert_eq(_cards.get_open(), HoleCards.Subject.HORIZON)
	assert_null(card.what_is_pointed_at(), "an open one is not chosen again")
	assert_false(card.choose())
	_cards.visible = false
	assert_eq(card.distance_along(eye, eye.direction_to(at)), INF, "not while hidden")


func test_without_room_there_are_none() -> void:
	_stand(1.02)
	_let_pass(0.1)
	assert_false(_cards.has_room())
	_stand(5.0)
	_let_pass(0.1)
	assert_true(_cards.has_room())
	_sky.lensing = 0.0
	_let_pass(0.3)
	assert_false(_cards.has_room(), "no hole, no cards")
	_sky.lensing = 1.0
	_let_pass(0.3)
	assert_true(_cards.has_room(), "it has come back")


## The head stands r radii away, so far round the hole.
func _stand(r: float, round_it: float = 0.0) -> void:
	var aside := Vector3(0.2, 0.1, 1.0).normalized().rotated(Vector3.UP, round_it)
	_head.global_position = HOLE + aside * r * _sky.schwarzschild_radius
	_head.look_at(HOLE)


func _let_pass(seconds: float) -> void:
	for i in roundi(seconds / 0.05):
		_cards._process(0.05)


func _place() -> Vector3:
	var away := _head.global_position - HOLE
	return _sky.global_basis.orthonormalized().inverse() * away / _sky.schwarzschild_radius


## As the sky draws it, with its direction in the world.
func _shadow() -> Dictionary:
	var observer := _sky.observer if _sky.observer != null else SkyObserver.new()
	var shadow := observer.shadow(_place())
	var direction: Vector3 = shadow["direction"]
	shadow["direction"] = _sky.global_basis.orthonormalized() * direction
	return shadow


func _seen(place: Vector3) -> Vector3:
	return _head.global_position.direction_to(place)


func _points_of(card: HoleCard) -> PackedVector3Array:
	var points: PackedVector3Array = []
	var size := card.get_size()
	for i in SAMPLES + 1:
		for j in SAMPLES + 1:
			var at := Vector3(float(i) / SAMPLES - 0.5, float(j) / SAMPLES - 0.5, 0.0)
			points.append(card.global_transform * (at * Vector3(size.x, size.y, 1.0)))
	return points


## How many cards but this one lie in a direction.
func _hits(direction: Vector3, but: int) -> int:
	var count := 0
	for i in 3:
		if i != but:
			var along := _cards.get_card(i).distance_along(_head.global_position, direction)
			count += 1 if along < INF else 0
	return count


func _open_cards() -> Array[int]:
	var found: Array[int] = []
	for i in 3:
		if _cards.get_card(i).is_open():
			found.append(i)
	return found


func _assert_fits(card: HoleCard, language: String) -> void:
	var words: SubViewport = card.get_node("Words")
	var panel := Rect2(Vector2.ZERO, words.size)
	assert_almost_eq(panel.size.aspect(), card.get_size().aspect(), 1e-3, "not distorted")
	for label: Label in [words.get_node("Title"), words.get_node("Text")]:
		if not label.visible:
			continue
		assert_gt(label.size.x, 0.0, "there is something")
		assert_true(panel.encloses(label.get_rect()), "%s: %s" % [language, label.text])
		assert_gte(label.get_rect().size.y, label.get_minimum_size().y, "no line is cut")
		var font := label.get_theme_font(&"font")
		for word in label.text.split(" "):
			var pixels := label.get_theme_font_size(&"font_size")
			var wide := font.get_string_size(word, HORIZONTAL_ALIGNMENT_LEFT, -1, pixels)
			assert_lte(wide.x, label.size.x, word)
