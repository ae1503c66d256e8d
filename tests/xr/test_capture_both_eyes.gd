# SPDX-License-Identifier: MIT
extends GutTest
## A shot with "xr" is taken by the headset's session: the left eye's picture beside the right
## one's, each with the hole before it.

@warning_ignore("untyped_declaration")
func should_skip_script():
	return XrVisit.missing()


func after_each() -> void:
	XrVisit.excuse(get_errors())


func test_a_shot_of_both_eyes() -> void:
	var near := await _take({"schwarzschild_radius_m": 0.3})
	if near == null:
		return
	var size := near.get_size()
	assert_eq(size.x % 2, 0)
	var half := Vector2i(size.x >> 1, size.y)
	var left := near.get_region(Rect2i(Vector2i.ZERO, half))
	var right := near.get_region(Rect2i(Vector2i(half.x, 0), half))
	for eye: Image in [left, right]:
		assert_lt(_mean(eye, Rect2(0.45, 0.45, 0.1, 0.1)), 1e-4, "the shadow is black")
		assert_gt(_mean(eye, Rect2(0.0, 0.0, 1.0, 1.0)), 0.003, "the sky is not")
	# The simulated headset's eyes have mirrored fields: the shadow is off the middle to either side.
	var off_left := _shadow_middle(left) - 0.5
	var off_right := _shadow_middle(right) - 0.5
	gut.p("the shadow is %.4f and %.4f of the width off the middle" % [off_left, off_right])
	assert_gt(off_left, 0.005)
	assert_lt(off_right, -0.005)
	var far := await _take({"schwarzschild_radius_m": 30.0, "stereo_baseline_scale": 0.0})
	assert_not_null(far, "and one more")
	if far != null:
		var wide := far.get_region(Rect2i(Vector2i.ZERO, half))
		assert_lt(_shadow_middle(wide) - 0.5, off_left - 0.005, "of a hole that is far away")


func _take(headset: Dictionary) -> Image:
	var spec := ShotSpec.from_data(
		{"position_rs": [0, 0, 6], "background": "grid", "stars": null, "xr": headset}
	)
	assert_eq(spec.error, "")
	var stage := ShotStage.new()
	add_child(stage)
	var refusal: PackedStringArray = []
	var picture := await stage.take(spec, refusal)
	assert_eq(refusal, PackedStringArray())
	stage.free()  # one session at a time
	return picture


func _mean(picture: Image, part: Rect2) -> float:
	var sum := 0.0
	for i in 20:
		for j in 20:
			var at := part.position + part.size * Vector2(i + 0.5, j + 0.5) / 20.0
			sum += picture.get_pixelv(Vector2i(at * Vector2(picture.get_size()))).get_luminance()
	return sum / 400.0


# Where the black in the picture's middle row lies, in parts of the width.
func _shadow_middle(picture: Image) -> float:
	var y := picture.get_height() >> 1
	var first := -1
	var last := -1
	for x in picture.get_width():
		if (
			picture.get_pixel(x, y).get_luminance() < 1e-5
			and absf(x - 0.5 * picture.get_width()) < 0.3 * picture.get_width()
		):
			first = x if first < 0 else first
			last = x
	return 0.5 * (first + last + 1) / picture.get_width()
