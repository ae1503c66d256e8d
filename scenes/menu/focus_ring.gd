# SPDX-License-Identifier: MIT
class_name FocusRing
extends RefCounted
## Lets the focus go round and round through controls, by up and down and by the tabulator.


## Links these, in their order.
static func link(controls: Array[Control]) -> void:
	for at in controls.size():
		var above := controls[at - 1]
		var below := controls[at]
		below.focus_neighbor_top = below.get_path_to(above)
		below.focus_previous = below.focus_neighbor_top
		above.focus_neighbor_bottom = above.get_path_to(below)
		above.focus_next = above.focus_neighbor_bottom
