# SPDX-License-Identifier: MIT
extends MenuCase
## The menu in the headset: each line can be reached with a hand and by looking, does what it says,
## and can be read in every language.

## So tall must an em be from where the menu opens, degrees.
const LEAST_EM: float = 2.6

var _booth: MenuBooth


func before_each() -> void:
	super()
	_booth = MenuBooth.new()
	add_child_autofree(_booth)


func _page_names() -> Array[StringName]:
	return _booth.pages.make().keys()


# All that a line could change, but for what other parts of the scene are asked.
func _state() -> Array:
	var sky := _booth.sky
	var comfort := _booth.comfort
	var state := [_booth.menu.get_page(), _booth.menu.is_open(), TranslationServer.get_locale()]
	state.append_array([_booth.switches.is_hole_wanted(), _booth.disk.visible, sky.background])
	state.append_array([_booth.disk_switches.preset, sky.image_orders, sky.overlays])
	state.append_array([sky.redshift_map, comfort.preset, comfort.smooth_turn, comfort.hands])
	state.append_array([comfort.smooth_flight, comfort.vignette, comfort.fixed_frame])
	state.append(comfort.stereo_baseline)
	return state


func _row(id: StringName) -> MenuRow:
	for row in _booth.rows():
		if row.item != null and row.item.id == id:
			return row
	return null


func test_it_opens_before_the_head_upright() -> void:
	var yaw := Basis(Vector3.UP, 1.0)
	var head := Transform3D(yaw * Basis(Vector3.RIGHT, -0.6), Vector3(2.0, 1.5, -1.0))
	watch_signals(_booth.menu)
	_booth.menu.open(head)
	assert_signal_emit_count(_booth.menu, "opened", 1)
	var away := yaw.inverse() * (_booth.menu.global_position - head.origin)
	assert_almost_eq(away, Vector3(0.0, -1.6 * tan(deg_to_rad(8.0)), -1.6), Vector3.ONE * 1e-5)
	assert_true(_booth.menu.global_basis.is_equal_approx(yaw))
	_booth.menu.toggle(head)
	assert_signal_emit_count(_booth.menu, "closed", 1)
	assert_false(_booth.menu.is_open())


func test_it_opens_before_one_who_looks_straight_down() -> void:
	for pitch: float in [-0.5 * PI, -0.49 * PI, 0.5 * PI]:
		var yaw := Basis(Vector3.UP, 2.0)
		assert_almost_eq(
			XrRig.backwards(yaw * Basis(Vector3.RIGHT, pitch)), yaw.z, Vector3.ONE * 1e-4
		)


func test_words_are_as_large_as_said() -> void:
	await _booth.show_page(VisitPages.FIRST)
	var surface := _booth.menu.surface
	var extent := surface.picture.get_extent()
	assert_almost_eq(rad_to_deg(2.0 * atan(0.5 * extent.x / 1.6)), 62.0, 0.1)
	assert_almost_eq(rad_to_deg(2.0 * atan(0.5 * extent.y / 1.6)), 50.0, 0.1)
	for row in _booth.rows():
		var em := row.em * extent.y / surface.pixels.y
		assert_gt(rad_to_deg(2.0 * atan(0.5 * em / 1.6)), LEAST_EM, row.words)
		assert_gt(
			rad_to_deg(2.0 * atan(0.5 * MenuSheet.FOOT_SHARE * em / 1.6)),
			LEAST_EM - 0.05,
			"in the foot"
		)


func test_words_fit_their_rows(
	locale: String = use_parameters(Array(LanguagePage.locales()))
) -> void:
	TranslationServer.set_locale(locale)
	_booth.told[VisitPages.SPECTATOR] = tr("Nothing")
	_booth.told[VisitPages.OBSERVER] = "Umkreisen"
	for page in _page_names():
		await _booth.show_page(page)
		assert_lt(_booth.rows().size(), MenuPage.MOST_ITEMS + 2)
		for row in _booth.rows():
			for value in 5 if row.item != null and row.item.kind == MenuItem.Kind.CHOICE else 1:
				assert_lte(row.get_needed_width(), row.size.x, "%s: %s" % [page, row.words])
				assert_gte(row.size.y, row.get_minimum_size().y - 0.5, row.words)
				var bounds := Rect2(Vector2.ZERO, _booth.menu.surface.pixels).grow(-30.0)
				assert_true(bounds.encloses(row.get_global_rect()), "on the panel: " + row.words)
				if row.item != null:
					assert_string_contains(row.words, tr(row.item.text))
				if row.item != null and row.item.kind == MenuItem.Kind.CHOICE:
					row.item.act()
					_booth.menu.refresh()
		var foot: Label = _booth.menu.sheet.get_node("%Foot")
		assert_lte(foot.get_line_count(), 2, foot.text)
		var title: Label = _booth.menu.sheet.get_node("%Title")
		assert_lte(title.get_combined_minimum_size().x, title.size.x)
		assert_lte(_text_width(title), title.size.x, title.text)


func _text_width(label: Label) -> float:
	var font := label.get_theme_font(&"font")
	var pixels := label.get_theme_font_size(&"font_size")
	return font.get_string_size(label.text, HORIZONTAL_ALIGNMENT_LEFT, -1.0, pixels).x


func test_every_line_can_be_pressed_with_a_hand() -> void:
	await _reach_all(func(row: MenuRow) -> void: _booth.press_at(_booth.place_of(row)))


func test_every_line_can_be_chosen_by_looking() -> void:
	await _reach_all(
		func(row: MenuRow) -> void:
			_booth.gaze_at(_booth.place_of(row), 3.0)
			_booth.look_away()
	)


# Reaches each line of each page; it must do something, and only once.
func _reach_all(reach: Callable) -> void:
	watch_signals(_booth.pages)
	watch_signals(_booth.menu)
	for page in _page_names():
		var count: int = _booth.pages.make()[page].items.size()
		for at in count + 1:
			TranslationServer.set_locale("de" if page == VisitPages.LANGUAGE and at == 1 else "en")
			await _booth.show_page(page)
			var row := _booth.rows()[at]
			var item := row.item
			var before := _state()
			var asked: int = get_signal_emit_count(_booth.pages, "asked")
			var chosen: int = get_signal_emit_count(_booth.menu, "chosen")
			reach.call(row)
			await _booth.settle()
			var which := "%s, %d" % [page, at]
			var was_asked: int = get_signal_emit_count(_booth.pages, "asked") - asked
			assert_lte(was_asked, 1, which)
			assert_true(was_asked == 1 or _state() != before, which + " does something")
			if item != null and item.kind != MenuItem.Kind.PAGE:
				assert_eq(get_signal_emit_count(_booth.menu, "chosen"), chosen + 1, which)
				assert_eq(_booth.menu.is_open(), not item.closes, which)


func test_other_parts_are_asked_by_name() -> void:
	watch_signals(_booth.pages)
	await _booth.show_page(VisitPages.RIDES)
	for id: StringName in [VisitPages.FALL, VisitPages.ORBIT_LEFT, VisitPages.PAUSE_RIDE]:
		await _booth.show_page(VisitPages.RIDES)
		_booth.press_at(_booth.place_of(_row(id)))
		await _booth.settle()
		assert_eq(get_signal_parameters(_booth.pages, "asked"), [id])


func test_what_is_impossible_does_nothing_and_says_why() -> void:
	watch_signals(_booth.pages)
	_booth.refused[VisitPages.FALL] = "There is no hole to fall into."
	await _booth.show_page(VisitPages.RIDES)
	var row := _row(VisitPages.FALL)
	assert_true(row.disabled)
	var hint := _booth.menu.sheet.get_foot()
	_booth.press_at(_booth.place_of(row))
	assert_eq(_booth.menu.sheet.get_foot(), "There is no hole to fall into.")
	_booth.gaze_at(_booth.place_of(row), 5.0)
	assert_eq(_booth.menu.sheet.get_foot(), "There is no hole to fall into.", "by looking too")
	assert_signal_not_emitted(_booth.pages, "asked")
	assert_null(_booth.menu.surface.what_is_pointed_at())
	_booth.gaze_at(_booth.place_of(_row(VisitPages.ORBIT_LEFT)), 0.2)
	assert_eq(_booth.menu.sheet.get_foot(), hint, "no longer")
	_booth.refused.clear()
	_booth.menu.refresh()
	assert_false(row.disabled)


func test_what_is_not_there_is_refused() -> void:
	_booth.pages.states.erase(VisitPages.CARDS)
	await _booth.show_page(VisitPages.EXPLAIN)
	assert_true(_row(VisitPages.CARDS).disabled)
	assert_ne(_row(VisitPages.CARDS).item.get_refusal(), "")


func test_the_row_under_the_ray_is_lit_and_no_other() -> void:
	await _booth.show_page(VisitPages.SKY)
	for row in _booth.rows():
		_booth.gaze_at(_booth.place_of(row), 0.1)
		for other in _booth.rows():
			assert_eq(other.lit, other == row, "%s, %s" % [row.words, other.words])
	_booth.look_away()
	for other in _booth.rows():
		assert_false(other.lit)


func test_what_a_new_page_puts_under_the_gaze_is_read_first() -> void:
	await _booth.show_page(VisitPages.SKY)
	var place := _booth.place_of(_row(&"background"))
	_booth.gaze_at(place, 0.1)
	watch_signals(_booth.menu)
	_booth.gaze_at(place, 2.0)
	assert_signal_not_emitted(_booth.menu, "chosen")
	_booth.gaze_at(place, 0.8)
	assert_signal_emit_count(_booth.menu, "chosen", 1)
	_booth.gaze_at(_booth.place_of(_row(&"orders")), 1.5)
	assert_signal_emit_count(_booth.menu, "chosen", 2, "the usual time from then on")


func test_the_menu_speaks_another_language_at_once() -> void:
	await _booth.show_page(VisitPages.LANGUAGE)
	var german := _row(&"language_de")
	assert_eq(german.words, "Deutsch")
	assert_false(german.value == true)
	_booth.press_at(_booth.place_of(german))
	await _booth.settle()
	assert_true(german.value == true)
	assert_false(_row(&"language_en").value == true)
	assert_eq((_booth.menu.sheet.get_node("%Title") as Label).text, "Sprache")
	assert_string_contains(_booth.rows()[0].words, "Zurück")


func test_every_language_has_a_name_of_its_own() -> void:
	for locale in LanguagePage.locales():
		assert_true(LanguagePage.OWN_NAMES.has(locale), locale)


func test_comfort_goes_by_presets_and_by_its_parts() -> void:
	await _booth.show_page(VisitPages.COMFORT)
	var comfort := _booth.comfort
	assert_eq(_row(&"preset").value, "Comfortable")
	_row(&"preset").item.act()
	assert_eq(comfort.preset, Comfort.Preset.FREE)
	_row(&"turning").item.act()
	_booth.menu.refresh()
	assert_eq(_row(&"preset").value, "Your own")
	_row(&"preset").item.act()
	assert_true(comfort.smooth_turn, "back to the preset")
	_row(&"tunnel").item.act()
	assert_gt(comfort.vignette, 0.0)
	var seen: PackedStringArray = []
	for i in 3:
		seen.append(str(_row(&"depth").item.get_value()))
		_row(&"depth").item.act()
	assert_eq(seen, PackedStringArray(["25 %", "50 %", "100 %"]))


func test_nothing_is_drawn_while_nothing_changes() -> void:
	await _booth.show_page(VisitPages.SKY)
	await _booth.settle()
	var viewport := _booth.menu.surface.picture.viewport
	viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	_booth.menu.refresh()
	await _booth.settle()
	assert_eq(viewport.render_target_update_mode, SubViewport.UPDATE_DISABLED)
	_booth.sky.image_orders = 1
	_booth.menu.refresh()
	await _booth.settle()
	assert_ne(viewport.render_target_update_mode, SubViewport.UPDATE_DISABLED)


func test_the_disc_opens_the_menu() -> void:
	var disc := MenuDisc.new()
	disc.head = _booth.head
	disc.menu = _booth.menu
	_booth.add_child(disc)
	await _booth.settle()
	var down := disc.global_position - _booth.head.global_position
	var level := Vector2(down.x, down.z).length()
	assert_almost_eq(rad_to_deg(atan2(-down.y, level)), disc.lower_degrees, 0.1)
	var width := disc.picture.width * MenuDiscFace.DISC
	assert_almost_eq(rad_to_deg(2.0 * atan(0.5 * width / down.length())), 3.5, 0.01)
	var faint := disc.picture.opacity
	_booth.pointer.advance(0.3)
	_booth.gaze_at(disc.global_position, 0.8)
	assert_false(_booth.menu.is_open())
	await _booth.settle()
	assert_gt(disc.picture.opacity, 4.0 * faint, "it appears when looked at")
	_booth.gaze_at(disc.global_position, 0.4)
	assert_true(_booth.menu.is_open())
	await _booth.settle()
	assert_false(disc.visible, "while the menu is in view")


func test_the_disc_comes_along_lazily() -> void:
	var disc := MenuDisc.new()
	disc.head = _booth.head
	_booth.add_child(disc)
	await _booth.settle()
	var first := disc.global_position
	_booth.head.rotation.y += deg_to_rad(50.0)
	disc._process(2.0)
	assert_almost_eq(disc.global_position, first, Vector3.ONE * 1e-3)
	_booth.head.rotation.y += deg_to_rad(20.0)
	for i in 100:
		disc._process(0.05)
	var ahead := -_booth.head.global_basis.z
	var towards := disc.global_position - _booth.head.global_position
	assert_lt(Vector2(ahead.x, ahead.z).angle_to(Vector2(towards.x, towards.z)), 0.01)


func test_an_exhibit_has_no_exit() -> void:
	KioskMode.set_on(true)
	var first := _booth.pages.make()[VisitPages.FIRST]
	KioskMode.set_on(false)
	for item in first.items:
		assert_ne(item.page, VisitPages.LEAVE)
	assert_eq(_booth.pages.make()[VisitPages.FIRST].items.size(), first.items.size() + 1)
