# SPDX-License-Identifier: MIT
## Packed arrays: elements, and copies that must not happen.
extends "res://cases/provider_case.gd"

var _calls := ProbeCalls.new()


func test_passing_copies_nothing() -> void:
	var values := PackedFloat32Array([1.0, 2.0, 3.0])
	var address := _calls.address_of(values)
	check(address != 0, "an address")
	equal(_calls.address_of(values), address, "typed call")
	equal(_calls.call("address_of", values), address, "dynamic call")
	var back := _calls.pass_floats(values)
	equal(_calls.address_of(back), address, "returned by a typed call")
	var dynamic: PackedFloat32Array = _calls.call("pass_floats", values)
	equal(_calls.address_of(dynamic), address, "returned by a dynamic call")
	back[0] = 9.0
	equal(values[0], 1.0, "writing to the returned array leaves the first alone")


func test_copies_share_until_written() -> void:
	var facts := _calls.packed_facts(PackedFloat32Array([1.0, 2.0, 3.0]))
	equal(facts["copy_shares"], true, "a copy shares its elements")
	equal(facts["variant_shares"], true, "so does a Variant")
	equal(facts["write_separates"], true, "writing separates")
	equal(facts["own_writes_stay"], true, "further writes stay in place")
	equal(facts["move_keeps"], true, "moving keeps the elements")
	equal(facts["sum"], 129.0, "42 + 43 + 44")
	equal(facts["bytes"], 12, "three floats")


func test_properties_share() -> void:
	var resource := ProbeResource.new()
	var values := PackedFloat32Array([1.0, 2.0])
	resource.data = values
	equal(_calls.address_of(resource.data), _calls.address_of(values), "through a property")


func test_every_kind() -> void:
	var wanted := {
		"byte": PackedByteArray([1, 2, 255]),
		"int32": PackedInt32Array([-1, 2147483647]),
		"int64": PackedInt64Array([-1, 9007199254740993]),
		"float32": PackedFloat32Array([0.5, -2.0]),
		"float64": PackedFloat64Array([0.1]),
		"string": PackedStringArray(["a", "b"]),
		"vector2": PackedVector2Array([Vector2(1, 2)]),
		"vector3": PackedVector3Array([Vector3(1, 2, 3)]),
		"color": PackedColorArray([Color.RED]),
		"word": "xy",
	}
	equal(_calls.packed_kinds(), wanted, "kinds")
