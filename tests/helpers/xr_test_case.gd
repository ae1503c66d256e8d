# SPDX-License-Identifier: MIT
class_name XrTestCase
extends GutTest
## A test on the simulated headset: each has a visit of its own.

var visit: XrVisit

@warning_ignore("untyped_declaration")
func should_skip_script():
	return XrVisit.missing()


func before_each() -> void:
	visit = XrVisit.new()
	add_child(visit)


func after_each() -> void:
	XrVisit.excuse(get_errors())
	visit.free()


## Begins the visit; false, and a failure, when the session does not come into focus.
func begun() -> bool:
	var well := await visit.begin()
	assert_true(well, "in focus")
	return well


## Nothing else is seen from now on: no hand points, and nothing waits to be pointed at.
func show_sky_alone() -> void:
	visit.scene.get_node("Headset/Origin/MenuDisc").hide()
	visit.headset.left.active = false
	visit.headset.right.active = false


## Puts the head there. The hole stays where it is from then on, or is put.
func move_head(pose: Transform3D) -> void:
	assert_true(await visit.settle(visit.scene.has_started), "the hole before the visitor")
	assert_true(await visit.move_head(pose), "head moved")


## What both eyes are shown, left first.
func take_pictures() -> Array[Image]:
	await wait_process_frames(6)
	var pictures := await EyeCapture.take(visit.scene.head, 10.0)
	assert_eq(pictures.size(), 2, "a picture for each eye")
	return pictures


## The eyes that saw these pictures, as far apart as the headset has them.
func eyes_of(pictures: Array[Image]) -> Array[EyeView]:
	var eyes: Array[EyeView] = []
	for view in pictures.size():
		eyes.append(EyeView.new(visit.scene, view, pictures[view].get_size()))
	var apart := eyes[0].place.distance_to(eyes[1].place)
	assert_almost_eq(apart, 2.0 * SimulatedHeadset.HALF_EYES, 1e-3, "between the eyes")
	return eyes
