# SPDX-License-Identifier: MIT
extends GutTest
## The check of texts finds what is cut off, covered or outside, and measures contrast.

var _page: Control


func before_each() -> void:
	var viewport := SubViewport.new()
	viewport.size = Vector2i(400, 300)
	add_child_autofree(viewport)
	_page = Control.new()
	_page.size = viewport.size
	viewport.add_child(_page)


func _label(text: String, at: Vector2, size := Vector2.ZERO) -> Label:
	var label := Label.new()
	label.text = text
	label.position = at
	label.clip_text = size != Vector2.ZERO
	_page.add_child(label)
	label.size = size
	return label


func test_a_good_page_has_no_problem() -> void:
	_label("One", Vector2(10.0, 10.0))
	_label("Two", Vector2(10.0, 60.0))
	await wait_process_frames(2)
	assert_eq(TextCheck.texts(_page).size(), 2)
	assert_eq(TextCheck.misplaced(_page), PackedStringArray())


func test_what_is_cut_off_is_found() -> void:
	_label("A line that is much longer than its place", Vector2(10.0, 10.0), Vector2(60.0, 24.0))
	await wait_process_frames(2)
	assert_string_contains("\n".join(TextCheck.misplaced(_page)), "cut off")


func test_what_is_outside_is_found() -> void:
	_label("Outside", Vector2(-40.0, 10.0))
	var box := Panel.new()
	box.position = Vector2(100.0, 100.0)
	box.size = Vector2(40.0, 30.0)
	_page.add_child(box)
	var inside := _label("Wider than its box", Vector2.ZERO)
	inside.reparent(box, false)
	await wait_process_frames(2)
	var found := "\n".join(TextCheck.misplaced(_page))
	assert_string_contains(found, "outside of the window")
	assert_string_contains(found, "outside of its box")


func test_what_lies_over_another_is_found() -> void:
	_label("Below", Vector2(10.0, 10.0))
	_label("Above", Vector2(14.0, 12.0))
	await wait_process_frames(2)
	assert_string_contains("\n".join(TextCheck.misplaced(_page)), "overlap")


func test_hidden_and_empty_texts_do_not_count() -> void:
	_label("", Vector2(-40.0, 10.0))
	_label("Hidden", Vector2(-40.0, 10.0)).hide()
	_label("Clear", Vector2(-40.0, 10.0)).modulate.a = 0.0
	assert_eq(TextCheck.texts(_page).size(), 0)


func test_contrast_is_that_of_the_pixels() -> void:
	var label := _label("Text", Vector2(10.0, 10.0))
	await wait_process_frames(2)
	var size := Vector2i(_page.get_viewport().get_visible_rect().size)
	var picture := Image.create_empty(size.x, size.y, false, Image.FORMAT_RGB8)
	picture.fill(Color.BLACK)
	var rect := Rect2i(label.get_global_rect())
	assert_almost_eq(TextCheck.contrast(label, picture), 1.0, 1e-3)
	# A tenth of the place in white: 21 to 1.
	rect.size.y = ceili(0.1 * rect.size.y)
	picture.fill_rect(rect, Color.WHITE)
	assert_almost_eq(TextCheck.contrast(label, picture), 21.0, 0.1)
	picture.fill(Color(0.5, 0.5, 0.5))
	picture.fill_rect(rect, Color(0.6, 0.6, 0.6))
	assert_lt(TextCheck.contrast(label, picture), TextCheck.LEAST_CONTRAST)
	assert_eq(TextCheck.faint(_page, picture).size(), 1)
