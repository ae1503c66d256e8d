# SPDX-License-Identifier: MIT
extends GutTest
## No text of any page or station is cut off or covered, in any language, at the usual sizes of
## windows: in German, whose words are the longest, in each run; with ./test --all in every language
## and size, and at the smaller one before the sky, and their contrast is measured.

const SCENE: PackedScene = preload("res://scenes/desktop/desktop.tscn")
const SIZES: Array[Vector2i] = [Vector2i(1280, 720), Vector2i(1920, 1080)]

var _size: Vector2i
var _locale: String
var _encoder: DisplayEncoder

@warning_ignore("untyped_declaration")
func should_skip_script():
	if RenderingServer.get_current_rendering_method() == "mobile":
		return false
	return "texts and menus are the same in every renderer"


func before_all() -> void:
	_size = get_window().size
	_locale = TranslationServer.get_locale()


func before_each() -> void:
	_encoder = DisplayEncoder.new()
	add_child_autofree(_encoder)


func after_all() -> void:
	get_window().size = _size
	TranslationServer.set_locale(_locale)


func test_texts_can_be_read(locale: String = use_parameters(_locales())) -> void:
	for size: Vector2i in SIZES.slice(0, 2 if RendererScope.is_everything_wanted() else 1):
		get_window().size = size
		await wait_process_frames(2)
		assert_eq(get_window().size, size)
		await _look_at_all(locale)


func _locales() -> Array:
	return ["de", "en"] if RendererScope.is_everything_wanted() else ["de"]


func _look_at_all(locale: String) -> void:
	var scene := SCENE.instantiate() as DesktopScene
	add_child_autofree(scene)
	var sky: BlackHoleSky = scene.get_node("Sky")
	sky.visible = RendererScope.is_everything_wanted() and get_window().size == SIZES[0]
	TranslationServer.set_locale(locale)
	var screens := DesktopScreens.new(scene)
	assert_gt(screens.get_names().size(), 40)
	for page in screens.get_names():
		screens.show(page)
		await wait_process_frames(2)
		var problems := TextCheck.misplaced(scene)
		if sky.visible:
			await wait_seconds(0.6)
			# On a busy machine that is a frame or two, and what fades in has not yet ended.
			await wait_process_frames(4)
			await RenderingServer.frame_post_draw
			var picture: Image = await _encoder.encode(get_window().get_texture().get_image())
			problems += TextCheck.faint(scene, picture)
		assert_eq("\n".join(problems), "", "%s %s %s" % [get_window().size, locale, page])
		screens.clear()
	scene.queue_free()
	await wait_process_frames(1)
