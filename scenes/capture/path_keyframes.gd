# SPDX-License-Identifier: MIT
class_name PathKeyframes
extends PathCourse
## A smooth way through the places of a shot's "path.keyframes".
##
## Places, aims and upward directions follow a TimedSpline, the field of view one in its logarithm.
## What a keyframe leaves out is there as the shot itself says. Before the first and after the last
## keyframe the eye rests.

const NARROWEST_DEG: float = 0.01
const WIDEST_DEG: float = 179.0

var _fps: float
## By key of the shot; those that no keyframe names are missing.
var _splines: Dictionary[String, TimedSpline] = {}


## `shot` has passed the schema.
func _init(shot: Dictionary, fps: float) -> void:
	_fps = fps
	var path: Dictionary = shot["path"]
	var keyframes: Array = path["keyframes"]
	if shot.has("position_rs"):
		error = "position_rs: the keyframes say where the eye is; leave it out."
		return
	var times := _times(keyframes, path["duration_s"])
	for key: String in ["position_rs", "look_at_rs", "up", "vertical_fov_deg"]:
		if error.is_empty() and keyframes.any(func(frame: Dictionary) -> bool: return key in frame):
			_splines[key] = TimedSpline.new(times, _points(keyframes, key, shot))
	if _splines.has("look_at_rs") and shot.get("aim") == "apparent":
		error = (
			'path.keyframes: aim "apparent" centres the hole; '
			+ "leave look_at_rs out of the keyframes, or aim out."
		)


func pose(frame: int) -> Dictionary:
	var keys := {}
	for key in _splines:
		var value := _splines[key].at(frame / _fps)
		if key == "vertical_fov_deg":
			keys[key] = clampf(exp(value[0]), NARROWEST_DEG, WIDEST_DEG)
		else:
			keys[key] = value
	return keys


func _times(keyframes: Array, duration: float) -> PackedFloat64Array:
	var times: PackedFloat64Array = []
	for i in keyframes.size():
		var time: float = keyframes[i]["t"]
		if i > 0 and time <= times[i - 1]:
			var text := "path.keyframes[%d].t must be above that of the keyframe before, %s, not %s."
			error = text % [i, JsonWords.value(times[i - 1]), JsonWords.value(time)]
		elif time > duration:
			var text := "path.keyframes[%d].t must not be above path.duration_s, %s, but is %s."
			error = text % [i, JsonWords.value(duration), JsonWords.value(time)]
		if not error.is_empty():
			return []
		times.append(time)
	return times


func _points(keyframes: Array, key: String, shot: Dictionary) -> Array[PackedFloat64Array]:
	var plain: Dictionary = {
		"position_rs": [0.0, 0.0, 0.0],
		"look_at_rs": shot.get("look_at_rs", [0.0, 0.0, 0.0]),
		"up": shot.get("up", ShotSpec.UPWARD),
		"vertical_fov_deg": shot.get("vertical_fov_deg", ShotSpec.VERTICAL_FOV_DEG),
	}
	var points: Array[PackedFloat64Array] = []
	for keyframe: Dictionary in keyframes:
		var value: Variant = keyframe.get(key, plain[key])
		if key == "vertical_fov_deg":
			points.append(PackedFloat64Array([log(value)]))
		elif key == "up":
			points.append(Vec3D.normalized(PackedFloat64Array(value)))
		else:
			points.append(PackedFloat64Array(value))
	return points
