# SPDX-License-Identifier: MIT
extends FuzzTarget
## The formulas of the physics cards, which translators write too.

var _style := FormulaStyle.with(ThemeDB.fallback_font, 22, Color.WHITE)


func _init() -> void:
	file_name = "formula.txt"
	words = [
		"\\frac{", "\\sqrt{", "\\paren{", "\\abs{", "\\text{", "\\quad", "\\sin", "_", "^", "{", "}"
	]


func seeds() -> Array[PackedByteArray]:
	var found: Array[PackedByteArray] = []
	for formula: String in [
		"g = \\sqrt{1 - \\frac{r_s}{r}}",
		"\\frac{d\\tau}{dt} = \\paren{1 - \\frac{r_s}{r}}^{1/2}",
		"\\text{speed} \\quad v_{esc}^2 \u2248 \\abs{\\cos x} - \\ln y",
	]:
		found.append(formula.to_utf8_buffer())
	return found


func read(path: String) -> FuzzAnswer:
	var answer := FuzzAnswer.new()
	var text := BoundedText.from_file(path, 4096).text
	var parser := FormulaParser.new()
	var box := parser.parse(text, _style)
	answer.demand(box != null, "a box")
	if not parser.error.is_empty():
		answer.complain([parser.error], "")
	return answer
