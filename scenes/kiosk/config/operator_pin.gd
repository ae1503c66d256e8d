# SPDX-License-Identifier: MIT
class_name OperatorPin
extends RefCounted
## Checks the operator's PIN. After a wrong one the next try has to wait, longer each time.

## Seconds to wait after the first wrong PIN, and at most.
const FIRST_WAIT: float = 2.0
const LONGEST_WAIT: float = 120.0

var _plain: String
var _salt: String
var _hash: String
var _wrong: int = 0
var _free_at: float = 0.0


## From the settings: the digits, or the SHA-256 of salt and digits with the salt.
static func from_setting(setting: Variant) -> OperatorPin:
	var pin := OperatorPin.new()
	if setting is Dictionary:
		var hashed: Dictionary = setting
		pin._salt = hashed["salt"]
		pin._hash = hashed["sha256"]
	else:
		pin._plain = str(setting)
	return pin


## Is there one at all?
func is_set() -> bool:
	return not _plain.is_empty() or not _hash.is_empty()


## Seconds until the next try counts, at the time `now`.
func get_wait(now: float) -> float:
	return maxf(_free_at - now, 0.0)


## Is this the PIN? While one has to wait nothing is.
func accepts(digits: String, now: float) -> bool:
	if get_wait(now) > 0.0:
		return false
	if _is_right(digits):
		_wrong = 0
		return true
	_wrong += 1
	_free_at = now + minf(FIRST_WAIT * pow(2.0, _wrong - 1), LONGEST_WAIT)
	return false


func _is_right(digits: String) -> bool:
	if not _hash.is_empty():
		return (_salt + digits).sha256_text() == _hash
	return digits == _plain
