# SPDX-License-Identifier: MIT
extends GutTest
## The physics cards: all there, short, translated, with formulas that can be read, and room for it
## all on the page.

const SCREEN: PackedScene = preload("res://scenes/cards/card_screen.tscn")
const THEME: Theme = preload("res://scenes/desktop/hud/hud_theme.tres")
const SET: PhysicsCardSet = preload("res://scenes/cards/cards.tres")
const MOST_WORDS: int = 60
const SIZE := Vector2(1280.0, 720.0)

var _german := load("res://scenes/cards/locale/de.po") as Translation
var _figures := PlaceFigures.new()
var _locale: String


func before_all() -> void:
	_locale = TranslationServer.get_locale()
	TranslationServer.add_translation(_german)


func after_all() -> void:
	TranslationServer.set_locale(_locale)
	TranslationServer.remove_translation(_german)


func _words(text: String) -> int:
	return text.split(" ", false).size()


func _screen() -> CardScreen:
	var room := Control.new()
	room.theme = THEME
	room.size = SIZE
	add_child_autofree(room)
	var screen: CardScreen = SCREEN.instantiate()
	room.add_child(screen)
	screen.open()
	return screen


func test_every_effect_has_its_card() -> void:
	assert_gte(SET.cards.size(), 13)
	var titles := {}
	for card in SET.cards:
		titles[card.title] = true
	assert_eq(titles.size(), SET.cards.size(), "no title twice")


func test_cards_are_short_and_translated() -> void:
	for card in SET.cards:
		for text: String in [card.title, card.text, card.legend]:
			assert_ne(text, "", card.title)
			assert_ne(_german.get_message(text), &"", "German of: %s" % text)
		assert_lte(_words(card.text), MOST_WORDS, card.title)
		assert_lte(_words(_german.get_message(card.text)), MOST_WORDS, "German of " + card.title)
		assert_true(_figures.get_names().has(card.figure), "%s: %s" % [card.title, card.figure])


func test_formulas_can_be_read() -> void:
	var style := FormulaStyle.with(ThemeDB.fallback_font, CardScreen.FORMULA_PIXELS, Color.WHITE)
	for card in SET.cards:
		assert_gt(card.formulas.size(), 0, card.title)
		for formula in card.formulas:
			var parser := FormulaParser.new()
			assert_gt(parser.parse(formula, style).width, 0.0)
			assert_eq(parser.error, "", card.title)


func test_the_font_has_every_sign() -> void:
	var font := ThemeDB.fallback_font
	for card in SET.cards:
		for text: String in card.formulas + PackedStringArray([card.text, card.legend]):
			for letter in text:
				assert_true(font.has_char(letter.unicode_at(0)), "%s in %s" % [letter, card.title])


func test_everything_fits_on_the_page(locale: String = use_parameters(["en", "de"])) -> void:
	TranslationServer.set_locale(locale)
	var screen := _screen()
	var scroll: ScrollContainer = screen.get_node("%CardScroll")
	var content: Control = screen.get_node("%Card")
	for i in SET.cards.size():
		screen.show_card(i)
		await wait_process_frames(2)
		var title := SET.cards[i].title
		assert_lte(content.get_combined_minimum_size().y, scroll.size.y, "%s: height" % title)
		assert_lte(content.get_combined_minimum_size().x, scroll.size.x, "%s: width" % title)
	var list: Control = screen.get_node("%List")
	assert_lte(list.size.y, (list.get_parent() as Control).size.y, "the list")
	assert_lte(screen.get_combined_minimum_size().y, SIZE.y)


func test_keys_go_through_the_list() -> void:
	var screen := _screen()
	await wait_process_frames(2)
	assert_eq(screen.get_shown(), 0)
	_press(&"ui_down")
	assert_eq(screen.get_shown(), 1)
	_press(&"ui_up")
	_press(&"ui_up")
	assert_true((screen.get_node("%Close") as Button).has_focus(), "round to the end")
	assert_eq(screen.get_shown(), 0)
	_press(&"ui_accept")
	assert_false(screen.visible)


func test_what_cancels_closes() -> void:
	var screen := _screen()
	_press(&"ui_cancel")
	assert_false(screen.visible)


func _press(action: StringName) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventAction.new()
		event.action = action
		event.pressed = pressed
		get_tree().root.push_input(event)
