# SPDX-License-Identifier: MIT
extends GutTest
## The photo mode from end to end: an unusual view of the desktop scene is saved, and its JSON draws
## the same picture again, here and, with ./test --all, by the command.

const SCENE: PackedScene = preload("res://scenes/desktop/desktop.tscn")
const SIZE := Vector2i(192, 108)

var _folder := ScratchFolder.new("photos")
var _scene: DesktopScene
var _photo: PhotoMode
var _sky: BlackHoleSky

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_each() -> void:
	# Photos have a viewport of their own: what the window would draw is not looked at.
	get_tree().root.disable_3d = true
	_scene = SCENE.instantiate()
	add_child_autofree(_scene)
	_sky = _scene.get_node("Sky")
	_photo = _scene.get_node("%PhotoMode")
	_photo.folder = ProjectSettings.globalize_path(_folder.path)


func after_each() -> void:
	get_tree().root.disable_3d = false


func _set_the_unusual_up() -> void:
	var rig := _photo.controls.rig
	rig.place(Vector3(2.0, 2.5, -6.0), Quaternion.from_euler(Vector3(-0.2, 2.9, 0.1)))
	rig.face_hole(0.9)
	rig.turn(0.03, -0.02, deg_to_rad(25.0))
	_photo.controls.mode = ViewControls.Mode.FLIGHT
	_photo.controls.advance(0.0)
	var choice: ObserverChoice = _scene.get_node("Choice")
	assert_true(choice.choose(ObserverKind.Kind.ORBIT_LEFT, rig.get_position(), Vector3(0.2, 1, 0)))
	_photo.disk.show()
	_photo.disk.time = 77.25
	_sky.overlays = BlackHoleSky.OVERLAY_SHADOW_EDGE | BlackHoleSky.OVERLAY_EQUATORIAL_GRID
	_photo.labels.stars = StarNames.load_file()
	_photo.labels.stars_shown = true
	_photo.open()
	_sky.exposure = 1.0
	_sky.psf_model = BlackHoleSky.PSF_AIRY
	_sky.aperture_mm = 0.2
	_photo.camera.fov = 40.0


func _save(kind: String = "png") -> Array:
	var files: Array = []
	_photo.saved.connect(
		func(picture: String, shot: String) -> void: files.append_array([picture, shot]),
		CONNECT_ONE_SHOT
	)
	_photo.failed.connect(func(reason: String) -> void: files.append(reason), CONNECT_ONE_SHOT)
	_photo.save(kind, SIZE)
	for frame in 600:
		if not files.is_empty():
			break
		await wait_process_frames(1)
	return files


# The largest difference of a channel, in 255ths.
func _largest_difference(one: Image, other: Image) -> int:
	assert_eq(one.get_size(), other.get_size())
	var a := one.get_data()
	var b := other.get_data()
	assert_eq(a.size(), b.size())
	var largest := 0
	for i in a.size():
		largest = maxi(largest, absi(a[i] - b[i]))
	return largest


func test_the_json_draws_the_photo_again() -> void:
	_set_the_unusual_up()
	var files := await _save()
	assert_eq(files.size(), 2, "both files: %s" % [files])
	var picture: String = files[0]
	var shot: String = files[1]
	var photo := Image.load_from_file(picture)
	assert_eq(photo.get_size(), SIZE)
	assert_gt(photo.get_data().count(0), 100, "the shadow")
	assert_lt(photo.get_data().count(0), photo.get_data().size() >> 1, "the sky")
	var spec := ShotSpec.from_file(shot)
	assert_eq(spec.error, "")
	var stage := ShotStage.new()
	var encoder := DisplayEncoder.new()
	add_child_autofree(stage)
	add_child_autofree(encoder)
	var refusal := PackedStringArray()
	var again := await encoder.encode(await stage.take(spec, refusal))
	assert_lte(_largest_difference(photo, again), 1, "drawn here")
	if not RendererScope.is_everything_wanted():
		return
	var out := _photo.folder.path_join("again.png")
	var said: Array = []
	var command := ProjectSettings.globalize_path("res://run")
	assert_eq(OS.execute(command, ["capture", shot, out], said, true), 0, "".join(said))
	assert_lte(_largest_difference(photo, Image.load_from_file(out)), 1, "drawn by the command")


func test_the_photo_is_what_the_screen_shows() -> void:
	if not RendererScope.is_everything_wanted():
		pending("a long test, for ./test --all")
		return
	get_tree().root.disable_3d = false
	_set_the_unusual_up()
	_sky.psf_model = BlackHoleSky.PSF_GAUSSIAN
	_photo.hide()
	_scene.get_node("Display").set("layer", 1000)
	var window := get_tree().root
	for frame in 4:
		await RenderingServer.frame_post_draw
	var shown := await _as_displayed(window.get_texture().get_image())
	_photo.show()
	var taker: PhotoTaker = _photo.get_node("%Taker")
	var described := ShotFromScene.describe(
		_sky, _photo.camera, window.size, _photo.disk, _photo.labels
	)
	assert_eq(described.refusal, "")
	var path := _photo.folder.path_join("screen")
	taker.take(described, path, "png", _sky)
	for frame in 600:
		if not taker.is_busy():
			break
		await wait_process_frames(1)
	var photo := Image.load_from_file(path + ".png")
	# Where a test runner's own panel lies the window shows something else.
	var region := Rect2i(Rect2(Vector2(window.size) / 3.0, Vector2(window.size) / 3.0))
	# Half a step of dithering, or of cutting floats to eight bits.
	assert_lte(
		_mean_of_differences(shown.get_region(region), photo.get_region(region)), 0.6, "in 255ths"
	)


# Compatibility draws display values as they are; the others draw light.
func _as_displayed(picture: Image) -> Image:
	if not SkyBooth.is_linear():
		picture.convert(Image.FORMAT_RGB8)
		return picture
	var encoder := DisplayEncoder.new()
	add_child_autofree(encoder)
	return await encoder.encode(picture)


func _mean_of_differences(one: Image, other: Image) -> float:
	var a := one.get_data()
	var b := other.get_data()
	var sum := 0
	for i in a.size():
		sum += absi(a[i] - b[i])
	return float(sum) / a.size()


func test_an_exr_is_saved_by_forward_plus_and_refused_by_others_with_words() -> void:
	_photo.open()
	var said := await _save("exr")
	if RenderingServer.get_current_rendering_method() == "forward_plus":
		assert_eq(said.size(), 2, "picture and shot")
		var picture := Image.load_from_file(said[0])
		assert_false(picture.is_empty(), said[0])
		return
	assert_eq(said.size(), 1)
	assert_string_contains(said[0], "Forward+")


func test_nothing_is_overwritten_and_a_folder_in_the_way_is_named() -> void:
	_photo.open()
	var first := await _save()
	var second := await _save()
	assert_ne(first[0], second[0])
	_photo.folder = _photo.folder.path_join("file.txt")
	_folder.write_text("file.txt", "in the way")
	var refused := await _save()
	assert_eq(refused.size(), 1)
	assert_string_contains(refused[0], "cannot be written")
