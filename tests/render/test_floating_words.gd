# SPDX-License-Identifier: MIT
extends GutTest
## Words in the world are seen whole, on a plate that fits them, whatever their length.

const EM_METRES: float = 0.1

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func test_words_stand_whole_on_their_plate(
	text: String = use_parameters(
		["3", "At 3 rₛ the shadow is 90° wide", "word ".repeat(30).strip_edges()]
	)
) -> void:
	var words := FloatingWords.new()
	add_child_autofree(words)
	var camera := Camera3D.new()
	add_child_autofree(camera)
	camera.position.z = 3.0
	camera.make_current()
	words.set_words(text, EM_METRES)
	await wait_process_frames(6)
	var picture := words.viewport.get_texture().get_image()
	assert_eq(picture.get_size(), words.pixels)
	assert_almost_eq(words.get_extent().x, EM_METRES * words.pixels.x / FloatingWords.EM, 1e-4)
	var lit := _lit(picture)
	assert_gt(lit.size.x, 0, "there are words")
	var inner := Rect2i(Vector2i.ZERO, words.pixels).grow(-6)
	assert_true(inner.encloses(lit), "words %s within the plate %s" % [lit, inner])
	var middle := Vector2(lit.get_center()) / Vector2(words.pixels)
	assert_almost_eq(middle, Vector2(0.5, 0.5), Vector2(0.1, 0.15), "in the middle")
	assert_eq(words.get_words(), text)


# Where the picture is as bright as letters.
func _lit(picture: Image) -> Rect2i:
	var found := Rect2i()
	for y in picture.get_height():
		for x in picture.get_width():
			if picture.get_pixel(x, y).get_luminance() > 0.6:
				var here := Rect2i(x, y, 1, 1)
				found = here if found.size == Vector2i.ZERO else found.merge(here)
	return found
