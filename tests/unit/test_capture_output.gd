# SPDX-License-Identifier: MIT
extends GutTest
## Where captures are written: names of frames, what does not go together, whole files only.

var _folder := ScratchFolder.new("capture_output")
var _still := ShotSpec.from_data({"position_rs": [0, 0, 10]})
var _sequence := ShotSpec.from_data(
	{"path": {"fps": 2, "duration_s": 1, "ride": {"kind": "orbit", "from_rs": 3}}}
)


func test_names_of_frames(
	# the output, the frame, its file
	p: Array = use_parameters(
		[
			["a/b/", 0, "a/b/frame_0000.png"],
			["a/b/", 12345, "a/b/frame_12345.png"],
			["x_%04d.png", 7, "x_0007.png"],
			["100%d/x%d.png", 12, "100%d/x12.png"],
			["%3d of 9.exr", 4, "004 of 9.exr"],
		]
	)
) -> void:
	var output := CaptureOutput.new(p[0])
	assert_true(output.is_sequence)
	assert_eq(output.file(p[1]), p[2])


func test_stills_have_one_file() -> void:
	for out: String in ["a.png", "b%d/a.exr", "100%.png"]:
		var output := CaptureOutput.new(out)
		assert_false(output.is_sequence)
		assert_eq(output.file(), out)


func test_what_goes_together() -> void:
	for out: String in ["a.png", "a.PNG", "a.exr"]:
		assert_eq(CaptureOutput.new(out).refusal(_still, "forward_plus"), "")
	for out: String in ["a/", "a%02d.png", "a%d.exr"]:
		assert_eq(CaptureOutput.new(out).refusal(_sequence, "forward_plus"), "")


func test_what_does_not(
	# the output, whether for a sequence, words of the refusal
	p: Array = use_parameters(
		[
			["a.png", true, "the shot is a sequence (path)"],
			["a.exr", true, "the shot is a sequence (path)"],
			["a/", false, "the shot has no path"],
			["a%d.png", false, "the shot has no path"],
			["a.mp4", true, "put together by ./run capture"],
			["a.tiff", true, ".png or .exr"],
			["a%d.jpg", true, ".png or .exr"],
			["a", true, ".png or .exr"],
			["a%d.exr", true, "forward_plus; mobile"],
		]
	)
) -> void:
	var spec := _sequence if p[1] else _still
	assert_string_contains(CaptureOutput.new(p[0]).refusal(spec, "mobile"), p[2])


func test_only_whole_pictures_have_the_name() -> void:
	var output := CaptureOutput.new(_folder.file("p%d.png"))
	var picture := Image.create_empty(3, 2, false, Image.FORMAT_RGB8)
	picture.fill(Color8(10, 20, 30))
	assert_eq(output.write(picture, 5), OK)
	assert_eq(DirAccess.get_files_at(_folder.path), PackedStringArray(["p5.png"]))
	assert_eq(Image.load_from_file(_folder.file("p5.png")).get_pixel(2, 1), Color8(10, 20, 30))
	# Again over the one that is there.
	picture.fill(Color8(40, 50, 60))
	assert_eq(output.write(picture, 5), OK)
	assert_eq(Image.load_from_file(_folder.file("p5.png")).get_pixel(0, 0), Color8(40, 50, 60))
