# SPDX-License-Identifier: MIT
class_name KeyHints
extends HFlowContainer
## Says which keys and buttons do what on the page: glyphs, and a word for each.


func _init() -> void:
	add_theme_constant_override(&"h_separation", 18)
	add_theme_constant_override(&"v_separation", 6)


## Adds what these controls, as BindingText, do.
func add(controls: PackedStringArray, text: String) -> void:
	var hint := HBoxContainer.new()
	hint.add_theme_constant_override(&"separation", 6)
	for words in controls:
		hint.add_child(InputGlyph.of_event(BindingText.to_event(words)))
	var label := Label.new()
	label.text = text
	label.theme_type_variation = &"Caption"
	hint.add_child(label)
	add_child(hint)


func clear() -> void:
	for child in get_children():
		child.free()
