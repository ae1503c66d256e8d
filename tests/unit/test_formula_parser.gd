# SPDX-License-Identifier: MIT
extends GutTest
## Formulas are read and set: what is tall, what is refused.

const PIXELS: int = 24

var _style := FormulaStyle.with(ThemeDB.fallback_font, PIXELS, Color.WHITE)


func _box(formula: String) -> FormulaBox:
	var parser := FormulaParser.new()
	var box := parser.parse(formula, _style)
	assert_eq(parser.error, "", formula)
	return box


func _error(formula: String) -> String:
	var parser := FormulaParser.new()
	parser.parse(formula, _style)
	return parser.error


func test_a_minus_at_the_start_keeps_close() -> void:
	assert_lt(_box("e^{-x}").width, _box("e^{y-x}").width - _box("y").width * 0.7)


func test_parts_stand_one_after_the_other() -> void:
	assert_almost_eq(_box("ab").width, _box("a").width + _box("b").width, 1e-3)
	assert_almost_eq(_box("a b").width, _box("ab").width, 1e-3, "a space is none")
	assert_gt(_box("a=b").width, _box("ab").width + 0.5 * PIXELS, "room round signs")


func test_numbers_hold_together() -> void:
	var font := ThemeDB.fallback_font
	var width := font.get_string_size("15", HORIZONTAL_ALIGNMENT_LEFT, -1.0, PIXELS).x
	assert_almost_eq(_box("15").width, width, 1e-3)


func test_scripts_are_small_and_move() -> void:
	var plain := _box("x")
	var raised := _box("x^2")
	var lowered := _box("x_2")
	assert_gt(raised.ascent, plain.ascent)
	assert_gt(lowered.descent, plain.descent)
	assert_lt(raised.width, _box("x2").width, "smaller than beside")
	var both := _box("x_1^2")
	assert_almost_eq(both.width, maxf(_box("x_1").width, raised.width), 1e-3, "one over the other")
	assert_eq(both.ascent, raised.ascent)
	assert_eq(both.descent, lowered.descent)


func test_fractions_roots_and_brackets_grow() -> void:
	var fraction := _box("\\frac{a}{b}")
	assert_gt(fraction.get_height(), 1.8 * _box("a").get_height())
	assert_gt(_box("\\sqrt{\\frac{a}{b}}").ascent, fraction.ascent)
	assert_gt(_box("\\paren{\\frac{a}{b}}").width, fraction.width)
	assert_gte(_box("\\abs{\\frac{a}{b}}").get_height(), fraction.get_height())
	assert_gt(_box("\\frac{a}{b}^2").ascent, fraction.ascent, "over its end")


func test_names_and_words() -> void:
	assert_gt(_box("\\sin x").width, _box("x").width)
	assert_gt(_box("\\text{two words}").width, _box("\\text{two}").width)
	assert_gt(_box("a\\quad b").width, _box("ab").width + PIXELS)


func test_faults_are_named(
	p: Array = use_parameters(
		[
			["\\frac{a}", "missing"],
			["\\sqrt{a", "without }"],
			["a}", "without {"],
			["^2", "nothing before"],
			["a^1^2", "two of"],
			["\\cosh x", "\\cosh is unknown"],
			["\\text", "words"],
			["a_", "missing"],
		]
	)
) -> void:
	var formula: String = p[0]
	assert_string_contains(_error(formula), p[1])
	assert_string_contains(_error(formula), formula, "the formula is named")


func test_the_label_takes_the_room_that_the_formula_needs() -> void:
	var label := FormulaLabel.new()
	add_child_autofree(label)
	label.font_size = PIXELS
	label.formula = "\\frac{a}{b}"
	var box := _box("\\frac{a}{b}")
	assert_eq(label.get_combined_minimum_size(), Vector2(box.width, box.get_height()).ceil())
