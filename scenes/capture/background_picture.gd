# SPDX-License-Identifier: MIT
class_name BackgroundPicture
extends RefCounted
## The picture behind the stars of a shot, read from a file that may be anything.

## What textures can have on every graphics card that draws this.
const LARGEST_SIDE: int = 16384
const MOST_BYTES: int = 1 << 30
## The most that deflate unpacks from a byte, as pixels of one bit. WebP may do with less.
const MOST_PIXELS_PER_BYTE: int = 1032 * 8

## Null where there is an error.
var image: Image
## Why the picture was refused, with the remedy; empty when it is fine.
var error: String = ""


static func from_file(path: String) -> BackgroundPicture:
	var picture := BackgroundPicture.new()
	var reason := fault(path)
	if reason.is_empty():
		picture.image = Image.load_from_file(path)
		if picture.image == null or picture.image.is_empty():
			picture.image = null
			reason = "cannot be read as a picture. Save it again."
	if not reason.is_empty():
		picture.error = "background: %s %s" % [path, reason]
	return picture


## What the file's size and its first bytes say against it, to stand after its name; empty: nothing.
static func fault(path: String) -> String:
	var bytes := FileAccess.get_size(path)
	var size := PictureSize.of_file(path)
	if bytes > MOST_BYTES:
		return "is larger than 1 GiB. Make it smaller."
	if size == Vector2i.ZERO:
		return "cannot be read as a picture. Check that its name ends as its format does."
	if maxi(size.x, size.y) > LARGEST_SIDE:
		return (
			"has %d x %d pixels; each side may have %d. Make it smaller."
			% [size.x, size.y, LARGEST_SIDE]
		)
	if path.get_extension().to_lower() != "webp" and size.x * size.y > bytes * MOST_PIXELS_PER_BYTE:
		return (
			"has %d bytes, too few for its %d x %d pixels: it is cut off. Copy it again."
			% [bytes, size.x, size.y]
		)
	return ""
