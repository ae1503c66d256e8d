# SPDX-License-Identifier: MIT
class_name XrVisit
extends Node
## A visit to the XR scene with the simulated headset, for tests: the scene in the tree, the headset
## in the test's hands. It waits for states, not for frames: the headset has its own clock.

const SCENE: PackedScene = preload("res://scenes/xr/xr.tscn")
const PATIENCE_SECONDS: float = 40.0

var headset := SimulatedHeadset.new()
var scene: XrScene


## What a script returns from should_skip_script(): why there can be no visit here, or false.
static func missing() -> Variant:
	if SimulatedHeadset.is_there():
		return false
	return "no simulated headset; ./test xr brings one"


## Marks as expected what the engine says of a headset without bounds on the floor.
static func excuse(errors: Array) -> void:
	for error: GutTrackedError in errors:
		if error.contains_text("No extents available"):
			error.handled = true


## Opens the scene; false when the session did not come into focus.
func begin() -> bool:
	scene = SCENE.instantiate()
	add_child(scene)
	# The picture keeps its quality however slowly a processor draws it, for the headset alone.
	scene.quality.enabled = false
	scene.spectator.mode = Spectator.Mode.OFF
	if not headset.open():
		return false
	return await settle(func() -> bool: return headset.send() and scene.session.has_focus())


## Moves the head there and waits until the camera has followed.
func move_head(pose: Transform3D) -> bool:
	headset.head = pose
	headset.send()
	return await settle(func() -> bool: return _is_near(scene.session.get_head_pose(), pose))


## Waits until `is_so` returns true; false after PATIENCE_SECONDS.
func settle(is_so: Callable, seconds: float = PATIENCE_SECONDS) -> bool:
	return await Waiting.until(get_tree(), is_so, seconds)


func _is_near(pose: Transform3D, wanted: Transform3D) -> bool:
	return (
		pose.origin.distance_to(wanted.origin) < 1e-4 and pose.basis.is_equal_approx(wanted.basis)
	)


func _exit_tree() -> void:
	headset.close()
