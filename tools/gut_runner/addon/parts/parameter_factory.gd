# SPDX-License-Identifier: MIT
extends RefCounted
## Builds the lists that use_parameters() takes.


## One dictionary per entry of values, its keys the names. Missing values are null, surplus ones
## are left out; an entry that is no array is the first value.
static func named_parameters(names: Array, values: Array) -> Array:
	var named: Array = []
	for entry: Variant in values:
		var row: Array = entry if entry is Array else [entry]
		var one: Dictionary = {}
		for i: int in names.size():
			one[names[i]] = row[i] if i < row.size() else null
		named.append(one)
	return named
