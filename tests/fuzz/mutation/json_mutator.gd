# SPDX-License-Identifier: MIT
class_name JsonMutator
extends RefCounted
## Changes values of JSON data: keys dropped and renamed, types changed, numbers out of all range,
## lists and objects deep in each other.

const SCALARS: Array = [
	null,
	true,
	false,
	0,
	-1,
	0.5,
	1e-300,
	1e18,
	-1e300,
	2147483648,
	"",
	"x",
	"0",
	"\u0000",
	"\u00e9"
]
const DEPTHS: PackedInt32Array = [1, 5, 63, 70, 400, 1200]

var _random: RandomNumberGenerator


func _init(random: RandomNumberGenerator) -> void:
	_random = random


## The data changed in one to three places; `other` is some to take pieces from.
func changed(data: Variant, other: Variant) -> Variant:
	var result: Variant = _copy(data)
	for i in _random.randi_range(1, 3):
		result = _changed_once(result, other)
	return result


func _changed_once(data: Variant, other: Variant) -> Variant:
	var holders: Array = []
	_collect(data, holders, 0)
	if holders.is_empty() or _random.randf() < 0.02:
		return _replacement(data, other)
	var holder: Variant = holders[_random.randi() % holders.size()]
	if holder is Dictionary:
		_change_object(holder, other)
	else:
		_change_list(holder, other)
	return data


func _change_object(object: Dictionary, other: Variant) -> void:
	if object.is_empty():
		object["key"] = _piece(other)
		return
	var key: String = object.keys()[_random.randi() % object.size()]
	match _random.randi() % 6:
		0:
			object.erase(key)
		1:
			object[key + "s"] = object[key]
			object.erase(key)
		2:
			var piece: Variant = _piece(other)
			if piece is Dictionary:
				object.merge(_copy(piece), true)
		_:
			object[key] = _replacement(object[key], other)


func _change_list(list: Array, other: Variant) -> void:
	if list.is_empty():
		list.append(_piece(other))
		return
	var at := _random.randi() % list.size()
	match _random.randi() % 5:
		0:
			list.remove_at(at)
		1:
			list.insert(at, _copy(list[at]))
		2:
			# Many of a list of many lists would be a file that nobody waits for.
			var many: int = [2, 20, 1000][_random.randi() % 3]
			var is_plain := list[at] is not Array and list[at] is not Dictionary
			for i in many if is_plain else 3:
				list.append(_copy(list[at]))
		_:
			list[at] = _replacement(list[at], other)


func _replacement(value: Variant, other: Variant) -> Variant:
	var result: Variant = SCALARS[_random.randi() % SCALARS.size()]
	match _random.randi() % 8:
		0:
			result = _piece(other)
		1:
			result = _nested(value)
		2:
			result = [value]
		3:
			result = {"key": value}
		4:
			if JsonKinds.is_number(value):
				var number: float = value
				result = number * [-1.0, 0.0, 2.0, 1e-9, 1e9, 1.0000001][_random.randi() % 6]
		5:
			if value is String:
				var text: String = value
				result = text.repeat([2, 100, 20000][_random.randi() % 3]).left(50000)
	return result


func _nested(value: Variant) -> Variant:
	var is_list := _random.randf() < 0.5
	for i in DEPTHS[_random.randi() % DEPTHS.size()]:
		if is_list:
			value = [value]
		else:
			value = {"key": value}
	return value


func _piece(other: Variant) -> Variant:
	var holders: Array = []
	_collect(other, holders, 0)
	if holders.is_empty():
		return SCALARS[_random.randi() % SCALARS.size()]
	var holder: Variant = holders[_random.randi() % holders.size()]
	var values: Array = []
	if holder is Array:
		values = holder
	elif holder is Dictionary:
		var object: Dictionary = holder
		values = object.values()
	return (
		_copy(values[_random.randi() % values.size()]) if not values.is_empty() else _copy(holder)
	)


# What is in each other deeply is not followed to the end.
func _collect(data: Variant, holders: Array, depth: int) -> void:
	if depth > 20 or holders.size() > 500:
		return
	if data is Array:
		var list: Array = data
		holders.append(list)
		for item: Variant in list:
			_collect(item, holders, depth + 1)
	elif data is Dictionary:
		var object: Dictionary = data
		holders.append(object)
		for key: Variant in object:
			_collect(object[key], holders, depth + 1)


func _copy(value: Variant) -> Variant:
	if value is Array:
		var list: Array = value
		return list.duplicate(not JsonKinds.is_deeper(value, 100))
	if value is Dictionary:
		var object: Dictionary = value
		return object.duplicate(not JsonKinds.is_deeper(value, 100))
	return value
