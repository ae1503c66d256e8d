# SPDX-License-Identifier: MIT
class_name CheckResult
extends RefCounted
## What a check found: its worst measurement, and in words what is at fault and what helps.

var name: StringName
## What is compared with what.
var compares: String = ""
## What is wrong when the check fails, and what to do about it.
var fault: String = ""
var remedy: String = ""
## The measurement that comes nearest to its limit, or exceeds it most.
var quantity: String = ""
var unit: String = ""
var worst: float = 0.0
var limit: float = 0.0
## What else speaks against the card, in plain sentences.
var objections: PackedStringArray = []

var _worst_share: float = -1.0


## Takes a measurement; of several the one that is worst for its limit is kept. What is not a number
## is worse than anything.
func compare(what: String, error: float, most: float, in_unit: String = "") -> void:
	var share := absf(error) / most if most > 0.0 else (0.0 if error == 0.0 else INF)
	if is_nan(error):
		share = INF
	if share > _worst_share or is_nan(error):
		_worst_share = share
		quantity = what
		worst = absf(error)
		limit = most
		unit = in_unit


## Says that something is wrong that is no matter of degree.
func object(sentence: String) -> void:
	if sentence not in objections:
		objections.append(sentence)


## Has something been measured, and all of it within its limit, and is nothing objected?
func has_passed() -> bool:
	return objections.is_empty() and _worst_share >= 0.0 and _worst_share <= 1.0


## For JSON, which has no infinity.
func to_dictionary() -> Dictionary:
	var error: Variant = null
	if is_finite(worst):
		error = worst
	var found := {
		"check": name,
		"passed": has_passed(),
		"compares": compares,
		"quantity": quantity,
		"worst": error,
		"limit": limit,
		"unit": unit,
		"objections": Array(objections),
	}
	if not has_passed():
		found["fault"] = fault
		found["remedy"] = remedy
	return found
