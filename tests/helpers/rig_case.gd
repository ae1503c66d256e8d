# SPDX-License-Identifier: MIT
class_name RigCase
extends GutTest
## A test of ways to move: a head in a room before a hole, and two hands, without a headset.

var sky: BlackHoleSky
var origin: XROrigin3D
var head: Node3D
var rig: XrRig
var left: FakeHand
var right: FakeHand
var comfort: Comfort


func before_each() -> void:
	sky = BlackHoleSky.new()
	sky.schwarzschild_radius = 0.5
	origin = XROrigin3D.new()
	head = Node3D.new()
	left = FakeHand.new(true)
	right = FakeHand.new()
	comfort = Comfort.new()
	rig = XrRig.new()
	for node: Node in [sky, origin, comfort, rig]:
		add_child_autofree(node)
	for node: Node in [head, left, right]:
		origin.add_child(node)
	head.position = Vector3(0.3, 1.6, 0.2)
	sky.global_position = Vector3(0.3, 1.6, -2.3)  # five radii ahead
	rig.origin = origin
	rig.head = head
	rig.sky = sky
	rig.comfort = comfort


func hands() -> Array[XrHand]:
	return [left, right]


## Adds a node to the tree for the test.
func put(node: Node) -> void:
	add_child_autofree(node)
