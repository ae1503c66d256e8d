# SPDX-License-Identifier: MIT
class_name ShotPath
extends RefCounted
## A sequence instead of a still: how many frames, and where the eye is in each. Read from a shot's
## "path".

var fps: float
## Frame i is at the time i/fps; there are fps * duration_s of them, rounded, at least one.
var frame_count: int
## Why the path was refused; empty when it is fine.
var error: String = ""

var _shot: Dictionary
var _course: PathCourse


## Reads the path of a shot that has passed the schema.
static func from_data(shot: Dictionary) -> ShotPath:
	var path := ShotPath.new()
	path._read(shot)
	return path


## The shot's data with the eye where it is in a frame.
func pose(frame: int) -> Dictionary:
	return _shot.merged(_course.pose(frame), true)


## What is wrong in a frame, with its time.
func fault(frame: int, reason: String) -> String:
	return "path: at %s s (frame %d): %s" % [JsonWords.value(frame / fps), frame, reason]


func _read(shot: Dictionary) -> void:
	_shot = shot
	var data: Dictionary = shot["path"]
	fps = data["fps"]
	var duration: float = data["duration_s"]
	frame_count = maxi(1, roundi(fps * duration))
	if data.has("keyframes"):
		_course = PathKeyframes.new(shot, fps)
	elif data["ride"]["kind"] == "fall":
		_course = PathFall.new(shot, frame_count, fps)
	else:
		_course = PathOrbit.new(shot, frame_count, fps)
	error = _course.error
