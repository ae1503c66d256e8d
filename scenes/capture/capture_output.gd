# SPDX-License-Identifier: MIT
class_name CaptureOutput
extends RefCounted
## Where pictures go: one file, or for sequences a folder or a name with a place for the number of
## the frame, such as shots/frame_%04d.png.

const FRAME_NAME: String = "frame_%04d.png"
const MOVIES: PackedStringArray = ["avi", "mp4", "webm"]

## "png" or "exr"; anything else is refused.
var kind: String
var is_sequence: bool

var _pattern: String
## Where the number stands in the pattern, its length there, and the digits the number has at least.
var _start: int
var _length: int
var _digits: int


## `out` as it is given on the command line; folders end in a slash.
func _init(out: String) -> void:
	_pattern = out + FRAME_NAME if out.ends_with("/") else out
	kind = _pattern.get_extension().to_lower()
	var found := RegEx.create_from_string("%0?([0-9]*)d").search(_pattern.get_file())
	is_sequence = found != null
	if is_sequence:
		_start = _pattern.length() - _pattern.get_file().length() + found.get_start()
		_length = found.get_string().length()
		_digits = found.get_string(1).to_int()


## Why a shot cannot be written there with a renderer; empty when it can.
func refusal(spec: ShotSpec, renderer: String) -> String:
	if MOVIES.has(kind):
		return "movies are put together by ./run capture; here take a folder (OUT/) for the frames."
	if kind != "png" and kind != "exr":
		return "the output must end in .png or .exr, or for a sequence be a folder (OUT/)."
	if spec.sequence != null and not is_sequence:
		return (
			"the shot is a sequence (path), this is one picture; "
			+ "take a folder (OUT/), a name such as %s, or a movie." % FRAME_NAME
		)
	if spec.sequence == null and is_sequence:
		return "a folder and numbered frames are for sequences; the shot has no path."
	if kind == "exr" and renderer != "forward_plus":
		var text := "renderer: scene-linear .exr needs forward_plus; %s rounds too coarsely."
		return text % renderer
	return ""


## The file of a frame; of a still there is one.
func file(frame: int = 0) -> String:
	if not is_sequence:
		return _pattern
	var number := str(frame).pad_zeros(_digits)
	return _pattern.left(_start) + number + _pattern.substr(_start + _length)


## Writes a picture, of its kind. Under its name there never is half a file.
func write(picture: Image, frame: int = 0) -> Error:
	var path := file(frame)
	var part := path + ".part"
	DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	var status := picture.save_exr(part) if kind == "exr" else picture.save_png(part)
	return status if status != OK else DirAccess.rename_absolute(part, path)
