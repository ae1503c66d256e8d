# SPDX-License-Identifier: MIT
extends FuzzTarget
## Shots: the JSON that `./run capture` takes.

const SHOTS: String = "res://tests/data/shots/accepted.json"
## All frames of a sequence are checked when it is read, and with many that takes its time.
const MOST_FRAMES: float = 2000.0


func _init() -> void:
	file_name = "shot.json"
	is_json = true


func seeds() -> Array[PackedByteArray]:
	var found := texts(["res://docs/gallery/film.json", "res://scenes/main/first_picture.json"])
	var shots: Array = JSON.parse_string(FileAccess.get_file_as_string(SHOTS))
	for shot: Variant in shots:
		found.append(json(shot))
	return found


func read(path: String) -> FuzzAnswer:
	var answer := FuzzAnswer.new()
	if _frames(path) > MOST_FRAMES:
		answer.complaints = ["too many frames for a try"]
		return answer
	var spec := ShotSpec.from_file(path)
	if spec.error.is_empty():
		_demand_limits(spec, answer)
	else:
		# The file is named where it cannot be read, else a key.
		answer.complain([spec.error], "")
	return answer


func _frames(path: String) -> float:
	var parser := JSON.new()
	if parser.parse(BoundedText.from_file(path, ShotSpec.MOST_BYTES).text) != OK:
		return 0.0
	var shot: Dictionary = parser.data if parser.data is Dictionary else {}
	var course: Dictionary = shot["path"] if shot.get("path") is Dictionary else {}
	var numbers: PackedFloat64Array = [0.0, 0.0]
	for i in 2:
		var value: Variant = course.get(["fps", "duration_s"][i])
		numbers[i] = value if JsonKinds.is_number(value) else 0.0
	return numbers[0] * numbers[1]


func _demand_limits(spec: ShotSpec, answer: FuzzAnswer) -> void:
	var size := spec.resolution
	answer.demand(
		mini(size.x, size.y) >= 1 and maxi(size.x, size.y) <= 8192, "a size in its limits"
	)
	answer.demand(Vec3D.length(spec.position) <= 1e12, "a place in its limits")
	answer.demand(absf(Vec3D.length(spec.forward) - 1.0) < 1e-9, "a direction of length 1")
	answer.demand(absf(Vec3D.length(spec.up) - 1.0) < 1e-9, "an upward direction of length 1")
	answer.demand(absf(Vec3D.dot(spec.forward, spec.up)) < 1e-6, "upward is across forward")
	answer.demand(spec.vertical_fov_deg > 0.0 and spec.vertical_fov_deg < 180.0, "a field of view")
	answer.demand(is_finite(spec.exposure_ev) and is_finite(spec.magnitude_limit), "finite numbers")
	answer.demand(spec.orders >= 1 and spec.orders <= 4, "orders in their limits")
	answer.demand(is_finite(spec.psf_sigma_px) and spec.psf_sigma_px > 0.0, "a point spread")
	if spec.sequence != null:
		answer.demand(spec.sequence.frame_count >= 1, "a sequence has frames")
