# SPDX-License-Identifier: MIT
extends "layer_values.gd"
## Asserts on containers, strings and files.


## Equal down to every element; int and float are never equal inside arrays and dictionaries.
func assert_eq_deep(v1: Variant, v2: Variant) -> void:
	if _can_compare(v1, v2, ""):
		var equal: bool = _equal(v1, v2)
		var note: String = "" if equal else "they differ at " + _difference(v1, v2, "")
		_check(equal, "{0} expected to equal {1}", [v1, v2], note)


func assert_ne_deep(v1: Variant, v2: Variant) -> void:
	_check(not _equal(v1, v2), "{0} expected not to equal {1}", [v1, v2], "")


## The same object, array or dictionary, not only an equal one; values as is_same() has it.
func assert_same(v1: Variant, v2: Variant, text: Variant = "") -> void:
	_check(is_same(v1, v2), "{0} expected to be the same as {1}", [v1, v2], text)


func assert_not_same(v1: Variant, v2: Variant, text: Variant = "") -> void:
	_check(not is_same(v1, v2), "{0} expected not to be the same as {1}", [v1, v2], text)


## An element of an array, a key of a dictionary, or what the object's has() says.
func assert_has(obj: Variant, element: Variant, text: Variant = "") -> void:
	if _can_have(obj, text):
		_check(obj.has(element), "{0} expected to have {1}", [obj, element], text)


func assert_does_not_have(obj: Variant, element: Variant, text: Variant = "") -> void:
	if _can_have(obj, text):
		_check(not obj.has(element), "{0} expected not to have {1}", [obj, element], text)


func assert_string_contains(text: Variant, search: Variant, match_case: Variant = true) -> void:
	if _are_strings(text, search):
		var where: String = text if match_case else str(text).to_lower()
		var what: String = search if match_case else str(search).to_lower()
		_check(what in where, "{0} expected to contain {1}", [text, search], "")


func assert_string_starts_with(text: Variant, search: Variant, match_case: Variant = true) -> void:
	if _are_strings(text, search):
		var where: String = text if match_case else str(text).to_lower()
		var what: String = search if match_case else str(search).to_lower()
		_check(where.begins_with(what), "{0} expected to begin with {1}", [text, search], "")


func assert_string_ends_with(text: Variant, search: Variant, match_case: Variant = true) -> void:
	if _are_strings(text, search):
		var where: String = text if match_case else str(text).to_lower()
		var what: String = search if match_case else str(search).to_lower()
		_check(where.ends_with(what), "{0} expected to end with {1}", [text, search], "")


func assert_file_exists(file_path: Variant) -> void:
	_check(FileAccess.file_exists(file_path), "the file {0} expected to exist", [file_path], "")


func assert_file_does_not_exist(file_path: Variant) -> void:
	var absent: bool = not FileAccess.file_exists(file_path)
	_check(absent, "the file {0} expected not to exist", [file_path], "")


func assert_file_empty(file_path: Variant) -> void:
	_check(
		_file_size(file_path) == 0, "the file {0} expected to be there and empty", [file_path], ""
	)


func assert_file_not_empty(file_path: Variant) -> void:
	var filled: bool = _file_size(file_path) > 0
	_check(filled, "the file {0} expected to be there and not empty", [file_path], "")


## The length in bytes, -1 when there is no such file.
func _file_size(path: String) -> int:
	if not FileAccess.file_exists(path):
		return -1
	var file: FileAccess = FileAccess.open(path, FileAccess.READ)
	return -1 if file == null else file.get_length()


func _can_have(obj: Variant, text: Variant) -> bool:
	var type: int = typeof(obj)
	var is_container: bool = type == TYPE_DICTIONARY or type >= TYPE_ARRAY
	if is_container or (obj is Object and is_instance_valid(obj) and obj.has_method("has")):
		return true
	_check(false, "{0} has no has()", [obj], text)
	return false


func _are_strings(text: Variant, search: Variant) -> bool:
	if text is String and search is String and text != "" and search != "":
		return true
	_check(false, "{0} and {1} must both be strings and not empty", [text, search], "")
	return false


## Where two different values differ first, as a path and the two values there.
func _difference(a: Variant, b: Variant, path: String) -> String:
	if a is Array and b is Array:
		for i: int in mini(a.size(), b.size()):
			if not _deep_equal(a[i], b[i]):
				return _difference(a[i], b[i], "%s[%d]" % [path, i])
		return "%s: %d and %d elements" % [path, a.size(), b.size()]
	if a is Dictionary and b is Dictionary:
		for key: Variant in a:
			if not b.has(key):
				return "%s[%s] is missing in the second" % [path, key]
			if not _deep_equal(a[key], b[key]):
				return _difference(a[key], b[key], "%s[%s]" % [path, key])
		return "%s: the second has further keys" % path
	return "%s: %s and %s" % [path, _show(a), _show(b)]
