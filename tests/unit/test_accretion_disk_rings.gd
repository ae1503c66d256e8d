# SPDX-License-Identifier: MIT
extends GutTest
## Which rings an AccretionDisk takes.

var _disk: AccretionDisk


func before_each() -> void:
	_disk = autofree(AccretionDisk.new())


func test_radii_above_the_horizon_are_taken() -> void:
	_disk.ring_radii = [30.0, 1.05, 3.0]
	assert_eq(_disk.ring_radii, PackedFloat32Array([30.0, 1.05, 3.0]), "in the given order")
	_disk.ring_radii = []
	assert_eq(_disk.ring_radii.size(), 0)


func test_others_are_refused(
	p: Array = use_parameters([[[1.0]], [[3.0, NAN]], [[INF]], [[2, 3, 4, 5, 6, 7, 8, 9, 10]]])
) -> void:
	_disk.ring_radii = [3.0, 6.0]
	var radii: Array = p[0]
	_disk.ring_radii = PackedFloat32Array(radii)
	assert_push_warning("ring_radii")
	assert_eq(_disk.ring_radii, PackedFloat32Array([3.0, 6.0]))


func test_values_stay_within_their_limits() -> void:
	_disk.ring_highlight = -5
	assert_eq(_disk.ring_highlight, -1)
	_disk.ring_highlight = 3
	assert_eq(_disk.ring_highlight, 3)
	_disk.ring_width = 0.0
	assert_eq(_disk.ring_width, 0.5)
	_disk.look = AccretionDisk.LOOK_RINGS
	assert_eq(_disk.look, AccretionDisk.LOOK_RINGS)
