# SPDX-License-Identifier: MIT
class_name FuzzAnswer
extends RefCounted
## What a reader made of a file.

const ACCEPTED: String = "accepted"

## Refusals and complaints in the reader's words; empty when all was accepted.
var complaints: PackedStringArray = []
## What must hold and does not; empty when all is well.
var broken: String = ""


## Notes a property that must hold.
func demand(holds: bool, property: String) -> void:
	if not holds and broken.is_empty():
		broken = property


## Notes complaints, each of which must say something, and name the file unless `name` is empty.
func complain(texts: PackedStringArray, name: String) -> void:
	complaints.append_array(texts)
	for text in texts:
		demand(text.length() > name.length() + 8, "a complaint says why: '%s'" % text)
		demand(name.is_empty() or text.contains(name), "a complaint names %s: '%s'" % [name, text])


## The kind of answer: complaints without what they quote.
func kind() -> String:
	if complaints.is_empty():
		return ACCEPTED
	var quoted := RegEx.create_from_string("'[^']*'|\"[^\"]*\"|[-+0-9.e]+|, not .*|[^ -~]+")
	return quoted.sub(" | ".join(complaints).left(300), "#", true)
