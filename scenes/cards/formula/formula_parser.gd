# SPDX-License-Identifier: MIT
class_name FormulaParser
extends RefCounted
## Reads a formula in a small part of TeX's language:
##
## letters are variables, digits and signs are themselves; [code]a_b[/code], [code]a^b[/code],
## [code]{...}[/code] holds together; [code]\frac{a}{b}[/code], [code]\sqrt{a}[/code],
## [code]\paren{a}[/code] and [code]\abs{a}[/code] grow with what they hold; [code]\sin[/code] and
## its like, [code]\text{words}[/code], [code]\quad[/code] for a wide space. A space is none.

const FUNCTIONS: PackedStringArray = ["sin", "cos", "tan", "arccos", "ln", "exp"]
## Signs with space to both sides, of the size.
const RELATIONS: String = "=≈~<>"
const RELATION_SPACE: float = 0.26
const OPERATORS: String = "+−±·"
const OPERATOR_SPACE: float = 0.16
## After a comma, and round the names of functions.
const THIN_SPACE: float = 0.1
const WIDE_SPACE: float = 0.55
## So many brackets, fractions, roots and scripts may be in each other.
const DEEPEST: int = 24
## Signs that are not slanted, as digits are not.
const UPRIGHT: String = "0123456789.,:;()[]!/°∞′∂%"

## What is wrong with the formula; empty when it is fine.
var error: String = ""

var _text: String
var _at: int = 0
var _depth: int = 0


## The formula as a box; as far as it could be read, where there is an error.
func parse(formula: String, style: FormulaStyle) -> FormulaBox:
	_text = formula
	_at = 0
	_depth = 0
	error = ""
	var row := _row(style)
	if _at < _text.length():
		_refuse("} without {")
	return row


func _row(style: FormulaStyle) -> FormulaRow:
	var row := FormulaRow.new()
	while error.is_empty():
		_skip_spaces()
		var next := _peek()
		if next == "" or next == "}":
			break
		if next == "_" or next == "^":
			row.add(_scripts(row.take_last(), style))
		elif next == "-" and row.parts.is_empty():
			_take()
			row.add(FormulaText.new("−", style, false))
		else:
			row.add(_atom(style))
	return row


# One or both of a raised and a lowered part.
func _scripts(base: FormulaBox, style: FormulaStyle) -> FormulaBox:
	if base == null:
		_refuse("nothing before _ or ^")
		return FormulaBox.new()
	var raised: FormulaBox = null
	var lowered: FormulaBox = null
	while _peek() == "_" or _peek() == "^":
		var is_raised := _take() == "^"
		if raised != null if is_raised else lowered != null:
			_refuse("two of _ or ^ at once")
			break
		var script := _argument(style.script())
		if is_raised:
			raised = script
		else:
			lowered = script
		_skip_spaces()
	return FormulaScripts.new(base, raised, lowered, style)


# What is in braces, or one mark.
func _argument(style: FormulaStyle) -> FormulaBox:
	_skip_spaces()
	if _peek() != "{":
		if _peek() == "" or _peek() == "}":
			_refuse("something is missing at the end")
			return FormulaBox.new()
		return _atom(style)
	_take()
	_depth += 1
	if _depth > DEEPEST:
		_refuse("too much in each other")
	var inside := _row(style)
	_depth -= 1
	if _take() != "}":
		_refuse("{ without }")
	return inside


func _atom(style: FormulaStyle) -> FormulaBox:
	match _peek():
		"{":
			return _argument(style)
		"\\":
			return _command(style)
	var mark := _take()
	if mark == "-":
		mark = "−"
	if RELATIONS.contains(mark):
		return FormulaText.new(mark, style, false, RELATION_SPACE)
	if OPERATORS.contains(mark):
		return FormulaText.new(mark, style, false, OPERATOR_SPACE)
	if UPRIGHT.contains(mark):
		while _peek() != "" and "0123456789.".contains(mark[-1]) and _peek().is_valid_int():
			mark += _take()
		return FormulaText.new(mark, style, false)
	return FormulaText.new(mark, style, true)


func _command(style: FormulaStyle) -> FormulaBox:
	_take()
	var name := ""
	while _peek() != "" and _peek().to_lower() != _peek().to_upper() and _peek() < "{":
		name += _take()
	var box := FormulaBox.new()
	match name:
		"quad":
			box = FormulaText.new("", style, false, WIDE_SPACE)
		"text":
			box = FormulaText.new(_words(), style, false)
		"frac":
			var above := _argument(style)
			box = FormulaFraction.new(above, _argument(style), style)
		"sqrt":
			box = FormulaRoot.new(_argument(style), style)
		"paren":
			box = FormulaBrackets.new(_argument(style), style, false)
		"abs":
			box = FormulaBrackets.new(_argument(style), style, true)
		_ when FUNCTIONS.has(name):
			box = FormulaText.new(name, style, false, THIN_SPACE)
		_:
			_refuse("\\%s is unknown" % name)
	return box


func _words() -> String:
	var end := _text.find("}", _at)
	if _peek() != "{" or end < 0:
		_refuse("\\text needs {words}")
		return ""
	var words := _text.substr(_at + 1, end - _at - 1)
	_at = end + 1
	return words


func _skip_spaces() -> void:
	while _peek() == " ":
		_at += 1


func _peek() -> String:
	return _text[_at] if _at < _text.length() else ""


func _take() -> String:
	var mark := _peek()
	_at += 1
	return mark


func _refuse(reason: String) -> void:
	if error.is_empty():
		error = "%s (at %d in %s)" % [reason, _at, _text]
