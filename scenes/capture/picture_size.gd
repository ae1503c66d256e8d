# SPDX-License-Identifier: MIT
class_name PictureSize
extends RefCounted
## How large a picture is, told by the first bytes of its file: before the engine asks for memory
## to unpack it.

## In an EXR or Radiance header there may be so many bytes, and before the size of a JPEG or
## Radiance picture so many parts or lines.
const LONGEST_HEADER: int = 65536
const MOST_SEGMENTS: int = 1024

const _PNG: PackedByteArray = [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A]
const _EXR_MAGIC: int = 20000630


## Width and height in pixels; both 0 where the file is no picture of the kind its name says.
static func of_file(path: String) -> Vector2i:
	var file := FileAccess.open(path, FileAccess.READ)
	if file == null:
		return Vector2i.ZERO
	match path.get_extension().to_lower():
		"png":
			return _png(file)
		"jpg", "jpeg":
			return _jpeg(file)
		"webp":
			return _webp(file.get_buffer(30))
		"exr":
			return _exr(file.get_buffer(LONGEST_HEADER))
		"hdr":
			return _radiance(file)
	return Vector2i.ZERO


static func _png(file: FileAccess) -> Vector2i:
	if file.get_buffer(8) != _PNG:
		return Vector2i.ZERO
	file.big_endian = true
	file.seek(16)
	return _checked(file.get_32(), file.get_32())


# Segment after segment until the one that starts a frame.
static func _jpeg(file: FileAccess) -> Vector2i:
	file.big_endian = true
	if file.get_16() != 0xFFD8:
		return Vector2i.ZERO
	for i in MOST_SEGMENTS:
		var marker := file.get_16()
		var length := file.get_16()
		if marker < 0xFF01 or length < 2:
			break
		if marker >= 0xFFC0 and marker <= 0xFFCF and marker not in [0xFFC4, 0xFFC8, 0xFFCC]:
			file.get_8()
			var height := file.get_16()
			return _checked(file.get_16(), height)
		file.seek(file.get_position() + length - 2)
	return Vector2i.ZERO


static func _webp(head: PackedByteArray) -> Vector2i:
	if head.size() < 30 or _word(head, 0, 4) != "RIFF" or _word(head, 8, 4) != "WEBP":
		return Vector2i.ZERO
	match _word(head, 12, 4):
		"VP8 ":
			return _checked(head.decode_u16(26) & 0x3FFF, head.decode_u16(28) & 0x3FFF)
		"VP8L":
			var bits := head.decode_u32(21)
			return _checked((bits & 0x3FFF) + 1, (bits >> 14 & 0x3FFF) + 1)
		"VP8X":
			var width := (head.decode_u32(24) & 0xFFFFFF) + 1
			return _checked(width, (head.decode_u32(26) >> 8) + 1)
	return Vector2i.ZERO


# Attributes, each a name, a type, its size and its value, until an empty name.
static func _exr(head: PackedByteArray) -> Vector2i:
	if head.size() < 8 or head.decode_u32(0) != _EXR_MAGIC:
		return Vector2i.ZERO
	var at := 8
	while at < head.size() and head[at] != 0:
		var name_end := head.find(0, at)
		var type_end := head.find(0, name_end + 1) if name_end > 0 else -1
		if type_end < 0 or type_end + 5 > head.size():
			break
		var value := type_end + 5
		var length := head.decode_u32(type_end + 1)
		if _word(head, at, name_end - at) == "dataWindow" and value + 16 <= head.size():
			var width := head.decode_s32(value + 8) - head.decode_s32(value) + 1
			return _checked(width, head.decode_s32(value + 12) - head.decode_s32(value + 4) + 1)
		at = value + length
	return Vector2i.ZERO


# Lines of text, an empty one, and the size.
static func _radiance(file: FileAccess) -> Vector2i:
	var head := file.get_buffer(LONGEST_HEADER)
	if _word(head, 0, 2) != "#?":
		return Vector2i.ZERO
	var at := 0
	for i in MOST_SEGMENTS:
		var end := head.find(10, at)
		if end < 0:
			break
		var is_size := at > 1 and head[at - 1] == 10 and head[at - 2] == 10
		if is_size:
			return _radiance_size(_word(head, at, end - at).split(" ", false))
		at = end + 1
	return Vector2i.ZERO


static func _radiance_size(words: PackedStringArray) -> Vector2i:
	if words.size() == 4 and words[0] in ["-Y", "+Y"] and words[2] in ["-X", "+X"]:
		return _checked(_count(words[3]), _count(words[1]))
	return Vector2i.ZERO


# A number of pixels; 0 for a text that is none.
static func _count(text: String) -> int:
	return text.to_int() if text.is_valid_int() and text.length() < 10 else 0


# Printable characters alone: others are no part of any word that is looked for.
static func _word(bytes: PackedByteArray, from: int, length: int) -> String:
	var word := ""
	for i in range(from, mini(from + mini(length, 256), bytes.size())):
		word += String.chr(bytes[i]) if bytes[i] >= 32 and bytes[i] < 127 else "?"
	return word


static func _checked(width: int, height: int) -> Vector2i:
	if width <= 0 or height <= 0:
		return Vector2i.ZERO
	return Vector2i(mini(width, 0x7FFFFFFF), mini(height, 0x7FFFFFFF))
