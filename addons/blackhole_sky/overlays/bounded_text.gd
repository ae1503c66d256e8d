# SPDX-License-Identifier: MIT
class_name BoundedText
extends RefCounted
## The text of a file, read only where the file is no larger than such a file may be: memory is
## asked for after the size is known.

## The text; empty where there is an error.
var text: String
## Why there is no text, to stand after the file's name, with the remedy; empty when it is fine.
var error: String = ""


static func from_file(path: String, most_bytes: int) -> BoundedText:
	var read := BoundedText.new()
	var file := FileAccess.open(path, FileAccess.READ)
	if file == null:
		read.error = "is missing or cannot be read. Check the path."
	elif file.get_length() == 0:
		read.error = "is empty. Check the path."
	elif file.get_length() > most_bytes:
		read.error = (
			"has %d bytes; such a file may have %d. Check the path."
			% [file.get_length(), most_bytes]
		)
	else:
		read.text = text_of(file.get_buffer(file.get_length()))
		if read.text.is_empty():
			read.error = "is no UTF-8 text. Check the path, or save it in that encoding."
	return read


## What the bytes say; empty when they are no UTF-8 text. The engine would report each byte.
static func text_of(bytes: PackedByteArray) -> String:
	var following := 0
	var least := 0x80
	var most := 0xBF
	for byte in bytes:
		if following > 0:
			if byte < least or byte > most:
				return ""
			following -= 1
			least = 0x80
			most = 0xBF
		elif byte >= 0x80 or byte == 0:
			if byte < 0xC2 or byte > 0xF4:
				return ""
			following = 1 if byte < 0xE0 else (2 if byte < 0xF0 else 3)
			# Not in more bytes than needed, no surrogates, nothing beyond Unicode.
			if byte == 0xE0 or byte == 0xF0:
				least = 0xA0 if byte == 0xE0 else 0x90
			elif byte == 0xED or byte == 0xF4:
				most = 0x9F if byte == 0xED else 0x8F
	return bytes.get_string_from_utf8() if following == 0 else ""
