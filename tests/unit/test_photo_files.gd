# SPDX-License-Identifier: MIT
extends GutTest
## Names for photos: by date and number, never one that is taken.

const DATE: String = "2026-03-09"

var _folder := ScratchFolder.new("photo_names")


func test_numbers_go_up_and_nothing_is_overwritten() -> void:
	var first := PhotoFiles.next_name(_folder.path, DATE)
	assert_string_ends_with(first, "black_hole_2026-03-09_001")
	for kind: String in ["png", "json", "exr"]:
		var taken := PhotoFiles.next_name(_folder.path, DATE).get_file()
		_folder.write_text(taken + "." + kind, "taken")
	assert_string_ends_with(PhotoFiles.next_name(_folder.path, DATE), "_004")


func test_there_is_a_folder() -> void:
	var folder := PhotoFiles.folder()
	assert_true(DirAccess.dir_exists_absolute(folder), folder)
	assert_true(folder.is_absolute_path())
	assert_false(folder.begins_with("user://"), "a visitor can find it")


func test_sizes_have_the_shape_of_the_window() -> void:
	assert_eq(PhotoBar.resolution(0, Vector2i(1280, 720)), Vector2i(1280, 720))
	assert_eq(PhotoBar.resolution(1080, Vector2i(1280, 720)), Vector2i(1920, 1080))
	assert_eq(PhotoBar.resolution(2160, Vector2i(1920, 1080)), Vector2i(3840, 2160))
	assert_eq(PhotoBar.resolution(1080, Vector2i(1600, 1200)), Vector2i(1440, 1080))
	assert_eq(PhotoBar.resolution(2160, Vector2i(8000, 1000)).x, PhotoBar.LARGEST)


func test_roll_is_measured_from_north_and_to_the_right() -> void:
	var rig := ViewRig.new()
	rig.look_from(Vector3(3.0, 1.0, 8.0), Vector3.UP)
	assert_almost_eq(CameraRoll.of(Basis(rig.get_orientation())), 0.0, 1e-3)
	rig.turn(0.0, 0.0, deg_to_rad(30.0))
	assert_almost_eq(CameraRoll.of(Basis(rig.get_orientation())), 30.0, 1e-3)
	rig.turn(0.0, 0.0, deg_to_rad(-75.0))
	assert_almost_eq(CameraRoll.of(Basis(rig.get_orientation())), -45.0, 1e-3)
	rig.look_from(Vector3(0.0, 9.0, 0.0), Vector3.BACK)
	assert_eq(CameraRoll.of(Basis(rig.get_orientation())), 0.0, "nothing is up at the pole")
