# SPDX-License-Identifier: MIT
class_name PathOrbit
extends PathCourse
## A circular orbit in free fall, at even steps of proper time: a "path.ride" of kind "orbit".
##
## It starts on the radius through position_rs, or else where the z axis, or x where the orbit is
## about z, lies nearest to it. Only the part of the axis across that radius counts. Without slow
## motion the film is one turn, and its first frame follows on its last; with it a second of film
## shows 1/slow_motion r_s/c of proper time.

var _radius: float
## The two directions of the plane, the first that of the start, and the one across it.
var _ahead: PackedFloat64Array
var _aside: PackedFloat64Array
var _axis: PackedFloat64Array
## Turns from one frame to the next.
var _step: float


## `shot` has passed the schema.
func _init(shot: Dictionary, frame_count: int, fps: float) -> void:
	var ride: Dictionary = shot["path"]["ride"]
	_radius = ride["from_rs"]
	if shot.has("observer"):
		error = "observer: who rides on an orbit moves with it; leave observer out."
		return
	_axis = Vec3D.normalized(ride.get("axis", [0.0, 1.0, 0.0]))
	_ahead = shot.get("position_rs", _nearest_start())
	if Vec3D.length(_ahead) == 0.0 or Vec3D.sine(_axis, _ahead) < 1e-9:
		error = "position_rs gives the direction of the start; choose one across path.ride.axis."
		return
	_ahead = Vec3D.normalized(_ahead)
	_axis = Vec3D.normalized(Vec3D.part_across(_axis, _ahead))
	_aside = Vec3D.cross(_axis, _ahead)
	var orbit := CircularOrbitPath.new()
	var start := Vec3D.to_vector3(Vec3D.scaled(_ahead, _radius))
	if orbit.start(start, Vec3D.to_vector3(_axis)) != OK:
		error = "path.ride: %s" % orbit.get_error_message()
	elif ride.has("slow_motion"):
		_step = 1.0 / (fps * float(ride["slow_motion"]) * orbit.get_period())
	else:
		_step = 1.0 / frame_count


func pose(frame: int) -> Dictionary:
	var angle := TAU * fposmod(frame * _step, 1.0)
	var ahead := Vec3D.scaled(_ahead, _radius * cos(angle))
	var aside := Vec3D.scaled(_aside, _radius * sin(angle))
	return {
		"position_rs": Vec3D.add(ahead, aside),
		"observer": {"motion": "orbit", "axis": _axis},
	}


func _nearest_start() -> PackedFloat64Array:
	var start := Vec3D.part_across([0.0, 0.0, 1.0], _axis)
	if Vec3D.length(start) < 1e-6:
		start = Vec3D.part_across([1.0, 0.0, 0.0], _axis)
	return start
