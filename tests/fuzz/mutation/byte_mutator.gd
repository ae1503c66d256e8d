# SPDX-License-Identifier: MIT
class_name ByteMutator
extends RefCounted
## Changes files byte by byte and number by number, whatever they are.

const LONGEST: int = 200000
## What stands where a number was.
const NUMBERS: PackedStringArray = [
	"0",
	"-0",
	"-1",
	"1e308",
	"-1e308",
	"1e999",
	"-1e999",
	"NaN",
	"nan",
	"inf",
	"1e-320",
	"2147483648",
	"9223372036854775808",
	"99999999999999999999999999",
	"0.1.2",
	"0x1F",
	"1_000",
	"true",
	"null",
	'"1"',
	"[]",
	"{}",
]
const BYTES: PackedByteArray = [
	0, 9, 10, 13, 32, 34, 39, 44, 45, 91, 92, 93, 123, 125, 128, 192, 237, 255
]

var _random: RandomNumberGenerator
var _words: PackedStringArray
var _number := RegEx.create_from_string("[-+]?[0-9][0-9.eE+-]*")


func _init(random: RandomNumberGenerator, words: PackedStringArray) -> void:
	_random = random
	_words = words


## The file changed in one to four places; `other` is one to take pieces from.
func changed(bytes: PackedByteArray, other: PackedByteArray) -> PackedByteArray:
	var result := bytes.duplicate()
	for i in _random.randi_range(1, 4):
		result = _once(result, other)
		if result.size() > LONGEST:
			result.resize(LONGEST)
	return result


func _once(bytes: PackedByteArray, other: PackedByteArray) -> PackedByteArray:
	var at := _place(bytes)
	var end := mini(bytes.size(), at + 1 + _random.randi() % 32)
	var result := bytes
	match _random.randi() % 9:
		0:
			result = _flipped(bytes, at)
		1:
			result = bytes.slice(0, at) + bytes.slice(end)
		2:
			result = bytes.slice(0, end) + bytes.slice(at)
		3:
			result = bytes.slice(0, at)
		4:
			var from := _place(other)
			result = bytes.slice(0, at) + other.slice(from, from + 64) + bytes.slice(at)
		5, 6:
			result = _with_other_number(bytes)
		7:
			result = _with_word(bytes, at)
		_:
			result = bytes.slice(0, at) + _repeated() + bytes.slice(at)
	return result


func _place(bytes: PackedByteArray) -> int:
	return _random.randi() % (bytes.size() + 1)


func _flipped(bytes: PackedByteArray, at: int) -> PackedByteArray:
	if at < bytes.size():
		var is_known := _random.randf() < 0.5
		bytes[at] = BYTES[_random.randi() % BYTES.size()] if is_known else _random.randi() % 256
	return bytes


func _with_other_number(bytes: PackedByteArray) -> PackedByteArray:
	var text := BoundedText.text_of(bytes)
	var found := _number.search_all(text)
	if found.is_empty():
		return bytes
	var old := found[_random.randi() % found.size()]
	var fresh := NUMBERS[_random.randi() % NUMBERS.size()]
	return (text.left(old.get_start()) + fresh + text.substr(old.get_end())).to_utf8_buffer()


func _with_word(bytes: PackedByteArray, at: int) -> PackedByteArray:
	if _words.is_empty():
		return bytes
	var word := _words[_random.randi() % _words.size()].to_utf8_buffer()
	return bytes.slice(0, at) + word + bytes.slice(at)


# Many of one sign: brackets above all, one in another.
func _repeated() -> PackedByteArray:
	var many := PackedByteArray()
	many.resize([3, 70, 300, 3000, 70000][_random.randi() % 5])
	many.fill(BYTES[_random.randi() % BYTES.size()])
	return many
