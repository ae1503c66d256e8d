# SPDX-License-Identifier: MIT
class_name FuzzTarget
extends RefCounted
## A reader that is tried with broken files: what it begins with, and what must hold of its answer.

## Under which name the file is written that the reader gets.
var file_name: String = "input"
## Whether its files are JSON, so that values can be changed instead of characters.
var is_json: bool = false
## Words that mean something to the reader, beside those in its seeds.
var words: PackedStringArray = []


## Files to begin with, most of them good.
func seeds() -> Array[PackedByteArray]:
	return []


## Lets the reader read the file, and returns what it answered: what is accepted as
## [constant FuzzAnswer.ACCEPTED].
func read(_path: String) -> FuzzAnswer:
	return FuzzAnswer.new()


## Seeds from text files of the project.
static func texts(paths: PackedStringArray) -> Array[PackedByteArray]:
	var found: Array[PackedByteArray] = []
	for path in paths:
		found.append(FileAccess.get_file_as_bytes(path))
	return found


## A seed from a value.
static func json(value: Variant) -> PackedByteArray:
	return JSON.stringify(value).to_utf8_buffer()
