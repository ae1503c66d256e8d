# SPDX-License-Identifier: MIT
extends "layer_helpers.gd"
## Asserts on plain values.

const NUMBERS: Array[int] = [TYPE_INT, TYPE_FLOAT]
const TEXTS: Array[int] = [TYPE_STRING, TYPE_STRING_NAME]
const VECTORS: Dictionary[int, int] = {
	TYPE_VECTOR2: 2,
	TYPE_VECTOR2I: 2,
	TYPE_VECTOR3: 3,
	TYPE_VECTOR3I: 3,
	TYPE_VECTOR4: 4,
	TYPE_VECTOR4I: 4,
}
const ORDERED: Array[int] = [
	TYPE_INT,
	TYPE_FLOAT,
	TYPE_STRING,
	TYPE_STRING_NAME,
	TYPE_VECTOR2,
	TYPE_VECTOR2I,
	TYPE_VECTOR3,
	TYPE_VECTOR3I,
	TYPE_VECTOR4,
	TYPE_VECTOR4I,
]


## Equal by value. Different types fail, except int with float and String with StringName; inside
## arrays and dictionaries int and float differ.
func assert_eq(got: Variant, expected: Variant, text: Variant = "") -> void:
	if _can_compare(got, expected, text):
		_check(_equal(got, expected), "{0} expected to equal {1}", [got, expected], text)


func assert_ne(got: Variant, not_expected: Variant, text: Variant = "") -> void:
	if _can_compare(got, not_expected, text):
		var differ: bool = not _equal(got, not_expected)
		_check(differ, "{0} expected not to equal {1}", [got, not_expected], text)


## Within expected -+ error_interval, ends included; vectors by components, with a vector as
## interval. A NaN never passes.
func assert_almost_eq(
	got: Variant, expected: Variant, error_interval: Variant, text: Variant = ""
) -> void:
	if _can_be_near(got, expected, error_interval, text):
		var near: bool = _near(got, expected, error_interval) and not _has_nan(got)
		var values: Array = [got, expected, error_interval]
		_check(near, "{0} expected to equal {1} +/- {2}", values, text)


## Outside not_expected -+ error_interval. A NaN never passes.
func assert_almost_ne(
	got: Variant, not_expected: Variant, error_interval: Variant, text: Variant = ""
) -> void:
	if _can_be_near(got, not_expected, error_interval, text):
		var nan: bool = _has_nan(got) or _has_nan(not_expected) or _has_nan(error_interval)
		var far: bool = not nan and not _near(got, not_expected, error_interval)
		var values: Array = [got, not_expected, error_interval]
		_check(far, "{0} expected not to equal {1} +/- {2}", values, text)


func assert_gt(got: Variant, expected: Variant, text: Variant = "") -> void:
	if _can_order(got, expected, text):
		_check(got > expected, "{0} expected to be > {1}", [got, expected], text)


func assert_gte(got: Variant, expected: Variant, text: Variant = "") -> void:
	if _can_order(got, expected, text):
		_check(got >= expected, "{0} expected to be >= {1}", [got, expected], text)


func assert_lt(got: Variant, expected: Variant, text: Variant = "") -> void:
	if _can_order(got, expected, text):
		_check(got < expected, "{0} expected to be < {1}", [got, expected], text)


func assert_lte(got: Variant, expected: Variant, text: Variant = "") -> void:
	if _can_order(got, expected, text):
		_check(got <= expected, "{0} expected to be <= {1}", [got, expected], text)


## The value must be the bool true, not just something that counts as true.
func assert_true(got: Variant, text: Variant = "") -> void:
	_check(got is bool and got, "{0} expected to be true", [got], text)


func assert_false(got: Variant, text: Variant = "") -> void:
	_check(got is bool and not got, "{0} expected to be false", [got], text)


## expect_low <= got <= expect_high. A NaN never passes.
func assert_between(
	got: Variant, expect_low: Variant, expect_high: Variant, text: Variant = ""
) -> void:
	if _can_be_between(got, expect_low, expect_high, text):
		var inside: bool = got >= expect_low and got <= expect_high
		var values: Array = [got, expect_low, expect_high]
		_check(inside, "{0} expected to be between {1} and {2}", values, text)


## got <= expect_low or got >= expect_high. A NaN never passes.
func assert_not_between(
	got: Variant, expect_low: Variant, expect_high: Variant, text: Variant = ""
) -> void:
	if _can_be_between(got, expect_low, expect_high, text):
		var outside: bool = got <= expect_low or got >= expect_high
		var values: Array = [got, expect_low, expect_high]
		_check(outside, "{0} expected not to be between {1} and {2}", values, text)


func assert_null(got: Variant, text: Variant = "") -> void:
	_check(got == null, "{0} expected to be null", [got], text)


func assert_not_null(got: Variant, text: Variant = "") -> void:
	_check(got != null, "{0} expected not to be null", [got], text)


func assert_typeof(object: Variant, type: int, text: Variant = "") -> void:
	var holds: bool = typeof(object) == type
	_check(holds, "{0} expected to be of type " + type_string(type), [object], text)


func assert_not_typeof(object: Variant, type: int, text: Variant = "") -> void:
	var holds: bool = typeof(object) != type
	_check(holds, "{0} expected not to be of type " + type_string(type), [object], text)


## Whether two values are of types that are alike; fails the test when they are not. Null goes
## with all.
func _can_compare(a: Variant, b: Variant, text: Variant) -> bool:
	if a == null or b == null or _alike(a, b):
		return true
	var types: Array = [a, b, type_string(typeof(a)), type_string(typeof(b))]
	_check(false, "cannot compare {0} ({2}) with {1} ({3})", types, text)
	return false


func _can_order(a: Variant, b: Variant, text: Variant) -> bool:
	if a != null and b != null and typeof(a) in ORDERED and _alike(a, b):
		return true
	_check(false, "{0} and {1} have no order", [a, b], text)
	return false


func _can_be_between(got: Variant, low: Variant, high: Variant, text: Variant) -> bool:
	if not _can_order(got, low, text) or not _can_order(got, high, text):
		return false
	if low > high:
		_check(false, "{0} is not below {1}", [low, high], text)
		return false
	return true


func _can_be_near(got: Variant, expected: Variant, error: Variant, text: Variant) -> bool:
	if typeof(got) in NUMBERS or VECTORS.has(typeof(got)):
		if _alike(got, expected) and _alike(got, error):
			return true
	_check(false, "cannot compare {0} with {1} +/- {2}", [got, expected, error], text)
	return false


func _alike(a: Variant, b: Variant) -> bool:
	if typeof(a) == typeof(b):
		return true
	for family: Array[int] in [NUMBERS, TEXTS]:
		if typeof(a) in family and typeof(b) in family:
			return true
	return false


func _equal(a: Variant, b: Variant) -> bool:
	if a is Array or a is Dictionary:
		return _deep_equal(a, b)
	return a == b


## Equal down to every element, where int and float differ.
func _deep_equal(a: Variant, b: Variant) -> bool:
	if typeof(a) != typeof(b):
		return false
	if a is Array:
		return a.size() == b.size() and range(a.size()).all(_same_at.bind(a, b))
	if a is Dictionary:
		return a.size() == b.size() and a.keys().all(_same_at.bind(a, b))
	return a == b


func _same_at(key: Variant, a: Variant, b: Variant) -> bool:
	return (b is Array or b.has(key)) and _deep_equal(a[key], b[key])


func _near(got: Variant, expected: Variant, error: Variant) -> bool:
	if not VECTORS.has(typeof(got)):
		return got >= expected - error and got <= expected + error
	for i: int in VECTORS[typeof(got)]:
		if not (got[i] >= expected[i] - error[i] and got[i] <= expected[i] + error[i]):
			return false
	return true


func _has_nan(value: Variant) -> bool:
	if value is float:
		return is_nan(value)
	for i: int in VECTORS.get(typeof(value), 0):
		if is_nan(value[i]):
			return true
	return false
