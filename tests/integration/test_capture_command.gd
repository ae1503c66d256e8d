# SPDX-License-Identifier: MIT
extends GutTest
## The capture script as a command: what it refuses, with which words and exit status. It needs no
## renderer for that; the pictures are measured by tests/render.

const SCRIPT: String = "res://scenes/capture/capture.gd"

var _folder := ScratchFolder.new("capture")


func test_a_wrong_command_line_is_2() -> void:
	var said: Array = []
	assert_eq(_run([], said), 2)
	assert_string_contains(said[0], "SHOT.json")


func test_a_list_says_what_is_wrong_with_each_shot() -> void:
	var list: Array = [
		{"shot": {"position_rs": [0, 0, 5], "zoom": 3}, "out": "a.png"},
		{"shot": {"position_rs": [0, 0, 0.5]}, "out": "b.png"},
		{"shot": {"position_rs": [0, 0, 5]}, "out": "c.tiff"},
		{"shot": "missing.json", "out": "d.png"},
		{"shot": {"position_rs": [0, 0, 5]}},
		"no entry",
	]
	var path := _folder.write_text("list.json", JSON.stringify(list))
	var said: Array = []
	assert_eq(_run(["--batch", ProjectSettings.globalize_path(path)], said), 1)
	var text: String = said[0]
	for words: String in [
		"a.png: zoom is no key of a shot",
		"b.png: observer: no observer can be static",
		"c.tiff: the output must end in .png or .exr",
		"missing.json",
		'each entry needs "shot" and "out"',
	]:
		assert_string_contains(text, words)
	for picture: String in ["a.png", "b.png", "c.tiff", "d.png"]:
		assert_file_does_not_exist(_folder.file(picture))


func test_sequences_and_stills_each_to_their_kind_of_output() -> void:
	var path := {"fps": 2, "duration_s": 1, "ride": {"kind": "fall", "from_rs": 3}}
	var list: Array = [
		{"shot": {"path": path}, "out": "still.png"},
		{"shot": {"position_rs": [0, 0, 5]}, "out": "frames/"},
		{"shot": {"path": path}, "out": "movie.mp4"},
	]
	var file := _folder.write_text("list.json", JSON.stringify(list))
	var said: Array = []
	assert_eq(_run(["--batch", ProjectSettings.globalize_path(file)], said), 1)
	for words: String in [
		"still.png: the shot is a sequence (path), this is one picture",
		"frames/: a folder and numbered frames are for sequences",
		"movie.mp4: movies are put together by ./run capture",
	]:
		assert_string_contains(said[0], words)
	assert_eq(DirAccess.get_files_at(_folder.path), PackedStringArray(["list.json"]))


func test_a_list_that_is_none() -> void:
	var said: Array = []
	var path := ProjectSettings.globalize_path(_folder.write_text("list.json", "{}"))
	assert_eq(_run(["--batch", path], said), 1)
	assert_string_contains(said[0], "a batch is a JSON list")


func _run(arguments: PackedStringArray, said: Array) -> int:
	var command: PackedStringArray = [
		"--headless", "--path", ProjectSettings.globalize_path("res://"), "-s", SCRIPT, "--"
	]
	return OS.execute(OS.get_executable_path(), command + arguments, said, true)
