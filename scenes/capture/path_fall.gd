# SPDX-License-Identifier: MIT
class_name PathFall
extends PathCourse
## A free fall along a radius, at even steps of proper time: a shot's "path.ride" of kind "fall".
##
## The shot's observer says which fall: rain when there is none, or an infall. It is on the radius
## through position_rs, or else on the z axis. Without slow motion the first frame is at from_rs and
## the last at to_rs. With it a second of film shows 1/slow_motion r_s/c of proper time; the eye is
## held at to_rs once it has come there.

const LOWEST: float = 0.05

var _fall := RadialFallPath.new()
var _outward: PackedFloat64Array
var _observer: Dictionary
## Proper time from one frame to the next, and of the whole fall, in r_s/c.
var _step: float
var _end: float


## `shot` has passed the schema.
func _init(shot: Dictionary, frame_count: int, fps: float) -> void:
	var ride: Dictionary = shot["path"]["ride"]
	var from: float = ride["from_rs"]
	var to: float = ride.get("to_rs", LOWEST)
	if to >= from:
		error = (
			"path.ride.to_rs must be below from_rs, %s, not %s%s."
			% [
				JsonWords.value(from),
				JsonWords.value(to),
				"" if ride.has("to_rs") else " (its default)"
			]
		)
		return
	_outward = shot.get("position_rs", [0.0, 0.0, 1.0])
	if Vec3D.length(_outward) == 0.0:
		error = "position_rs gives the direction of the radius; it must not be [0, 0, 0]."
		return
	_outward = Vec3D.normalized(_outward)
	_start(shot.get("observer", "rain"), from)
	if not error.is_empty():
		return
	_end = _fall.proper_time_to(to)
	if ride.has("slow_motion"):
		_step = 1.0 / (fps * float(ride["slow_motion"]))
	else:
		_step = _end / maxi(1, frame_count - 1)


func pose(frame: int) -> Dictionary:
	return {"position_rs": Vec3D.scaled(_outward, radius(frame)), "observer": _observer}


## The radius in a frame, in Schwarzschild radii.
func radius(frame: int) -> float:
	return _fall.radius_at(minf(frame * _step, _end))


func _start(observer: Variant, from: float) -> void:
	_observer = {"motion": observer} if observer is String else observer
	if _observer["motion"] not in ["rain", "infall"] or _observer.get("outgoing", false):
		error = 'observer: a fall is "rain" or an "infall" that is not outgoing.'
		return
	var moving := ShotObserver.from_data(_observer, Vec3D.scaled(_outward, from))
	error = moving.error
	if not error.is_empty():
		return
	var started: Error
	if moving.rest_radius > 0.0 and from >= moving.rest_radius:
		started = _fall.start_from_rest(moving.rest_radius)
	else:
		started = _fall.start_with_energy(from, moving.energy)
	if started != OK:
		error = "path.ride: %s" % _fall.get_error_message()
