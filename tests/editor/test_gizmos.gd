# SPDX-License-Identifier: MIT
@tool
extends "editor_case.gd"
## Each node has its lines in the 3D view, of the right radii, whatever its transform.

const BELOW: float = 1e-4


func test_hole_and_disk_have_their_lines() -> void:
	await switch_plugin(true)
	var root := await open("res://scenes/full.tscn")
	var sky: BlackHoleSky = root.get_node("Sky")
	_expect_radii(sky, {&"horizon": 0.3, &"photon_sphere": 0.45, &"shadow": 0.45 * sqrt(3.0)})
	var disk: AccretionDisk = sky.get_node("Disk")
	_expect_radii(disk, {&"innermost_stable": 0.9, &"outer_edge": 2.7})
	disk.plunging_gas = true
	disk.outer_radius = 20.0
	await frames(3)
	_expect_radii(disk, {&"innermost_stable": 0.9, &"outer_edge": 6.0, &"inner_edge": 0.3})


func test_lines_follow_properties_but_not_the_scale() -> void:
	await switch_plugin(true)
	var root := await open("res://scenes/full.tscn")
	var sky: BlackHoleSky = root.get_node("Sky")
	sky.transform = Transform3D(
		Basis.from_euler(Vector3(0.3, 0.5, 0.0)).scaled(Vector3(3, 2, 1)), Vector3(1, 2, 3)
	)
	sky.schwarzschild_radius = 2.0
	sky.lensing = 0.5
	await frames(3)
	_expect_radii(sky, {&"horizon": 1.0, &"photon_sphere": 1.5, &"shadow": 1.5 * sqrt(3.0)})
	var disk: AccretionDisk = sky.get_node("Disk")
	_expect_radii(disk, {&"innermost_stable": 3.0})
	disk.look = AccretionDisk.LOOK_RINGS
	disk.ring_radii = [2.0]
	await frames(3)
	_expect_radii(disk, {&"rings": 2.0})


func test_orbits() -> void:
	await switch_plugin(true)
	var root := await open("res://scenes/full.tscn")
	var sky: BlackHoleSky = root.get_node("Sky")
	expect(not _lines_of(sky).has(&"orbit"), "no orbit of a static observer")
	sky.observer = SkyObserver.new()
	sky.observer.motion = LensingTable.MOTION_ORBIT
	await frames(3)
	var lines: PackedVector3Array = _lines_of(sky).get(&"orbit", PackedVector3Array())
	var shares := {"innermost": 0, "camera": 0}
	var camera: Camera3D = root.get_node("Camera")
	for point in lines:
		shares["innermost"] += 1 if absf(point.length() - 0.9) < BELOW else 0
		shares["camera"] += 1 if absf(point.length() - camera.position.length()) < 1e-3 else 0
	expect(shares["innermost"] > 100, "the innermost stable orbit: %s" % shares)
	expect(shares["camera"] > 100, "the camera's orbit: %s" % shares)


## Lines are in the node's axes; what is drawn is what its transform makes of them. Those that are
## turned to the camera are not scaled.
func _expect_radii(node: Node3D, radii: Dictionary[StringName, float]) -> void:
	var lines := _lines_of(node)
	var sky := node as BlackHoleSky if node is BlackHoleSky else node.get_parent() as BlackHoleSky
	for line: StringName in radii:
		if not lines.has(line):
			expect(false, "%s has no line %s" % [node.name, line])
			continue
		var frame := node.global_transform
		if line == &"shadow":
			frame = frame.orthonormalized()
		for point in lines[line]:
			var radius := (frame * point).distance_to(sky.global_position)
			if absf(radius - radii[line]) > BELOW:
				expect(false, "%s %s: %f instead of %f" % [node.name, line, radius, radii[line]])
				break


func _lines_of(node: Node3D) -> Dictionary[StringName, PackedVector3Array]:
	for gizmo: Node3DGizmo in node.get_gizmos():
		var lines: Variant = gizmo.get("lines")
		if lines is Dictionary:
			return lines
	expect(false, "%s has no gizmo of ours" % node.name)
	return {}
