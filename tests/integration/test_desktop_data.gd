# SPDX-License-Identifier: MIT
extends GutTest
## What is missing or damaged is said, and the scene runs all the same.

const SCENE: PackedScene = preload("res://scenes/desktop/desktop.tscn")
const DAMAGED_TABLE: String = "user://desktop_test_damaged.lut"
const DAMAGED_CATALOGUE: String = "user://desktop_test_damaged.stars"
const MISSING: String = "user://desktop_test_missing"

var _locale: String
var _scene: DesktopScene
var _sky: BlackHoleSky
var _data: SkyData
var _notices: NoticeBoard


func before_all() -> void:
	_locale = TranslationServer.get_locale()
	TranslationServer.set_locale("en")
	for path: String in [DAMAGED_TABLE, DAMAGED_CATALOGUE]:
		var file := FileAccess.open(path, FileAccess.WRITE)
		file.store_string("neither a table nor a catalogue")


func after_all() -> void:
	TranslationServer.set_locale(_locale)
	for path: String in [DAMAGED_TABLE, DAMAGED_CATALOGUE]:
		DirAccess.remove_absolute(path)


func before_each() -> void:
	_scene = SCENE.instantiate() as DesktopScene
	_sky = _scene.get_node("Sky")
	_data = _scene.get_node("Data")
	_notices = _scene.get_node("%Notices")


func _start() -> void:
	add_child_autofree(_scene)


# The engine reports a damaged file as an error as well; that is as it should be.
func _accept_errors() -> int:
	var count := 0
	for error: Variant in get_errors():
		error.handled = true
		count += 1
	return count


func test_a_missing_table_is_computed() -> void:
	_data.table_file = MISSING + ".lut"
	_start()
	assert_string_contains(_notices.get_text(SkyData.TABLE), "missing")
	assert_false(_sky.table.is_ready())
	assert_true(await wait_for_signal(_data.settled, 60.0), "computed in time")
	assert_true(_sky.table.is_ready())
	assert_eq(_notices.get_text(SkyData.TABLE), "", "the message is gone")
	await wait_process_frames(2)


func test_a_damaged_table_is_computed_anew() -> void:
	_data.table_file = DAMAGED_TABLE
	_start()
	assert_gt(_accept_errors(), 0, "reported")
	assert_string_contains(_notices.get_text(SkyData.TABLE), "damaged")
	assert_true(await wait_for_signal(_data.settled, 60.0), "computed in time")
	assert_true(_sky.table.is_ready())


func test_leaving_while_computing_is_harmless() -> void:
	_data.table_file = MISSING + ".lut"
	add_child(_scene)
	await wait_process_frames(1)
	_scene.free()
	await wait_seconds(0.3)
	pass_test("no crash")


func test_a_missing_catalogue() -> void:
	_data.catalogue_file = MISSING + ".stars"
	_start()
	assert_null(_sky.catalogue)
	assert_string_contains(_notices.get_text(SkyData.CATALOGUE), MISSING)
	await wait_process_frames(2)


func test_a_damaged_catalogue() -> void:
	_data.catalogue_file = DAMAGED_CATALOGUE
	_start()
	assert_gt(_accept_errors(), 0, "reported")
	assert_null(_sky.catalogue)
	assert_string_contains(_notices.get_text(SkyData.CATALOGUE), "cannot be read")
	await wait_process_frames(2)


func test_a_missing_panorama_makes_room_for_a_grid() -> void:
	_data.panorama_file = "res://scenes/desktop/there_is_none.exr"
	_start()
	assert_eq(_sky.background, BlackHoleSky.BACKGROUND_GRID)
	assert_string_contains(_notices.get_text(SkyData.PANORAMA), "grid")


func test_notices_go_by_themselves() -> void:
	_start()
	_notices.post(&"test", "A short notice", 0.1)
	_notices.post(&"lasting", "A lasting notice", 0.0)
	assert_eq(_notices.get_text(&"test"), "A short notice")
	await wait_seconds(0.3)
	assert_eq(_notices.get_text(&"test"), "")
	assert_eq(_notices.get_text(&"lasting"), "A lasting notice")
	_notices.post(&"lasting", "Another", 0.0)
	assert_eq(_notices.get_text(&"lasting"), "Another")
	_notices.take_down(&"lasting")
	_notices.take_down(&"lasting")
	assert_eq(_notices.get_text(&"lasting"), "")
