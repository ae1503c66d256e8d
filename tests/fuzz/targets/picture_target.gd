# SPDX-License-Identifier: MIT
extends FuzzTarget
## The sizes of pictures from the starts of their files. The file's name says which kind it is; here
## the first byte of the input does.

const KINDS: PackedStringArray = ["png", "jpg", "webp", "exr", "hdr"]
const HDR: String = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 3\n"


func _init() -> void:
	file_name = "picture"
	words = ["dataWindow", "box2i", "channels", "VP8 ", "VP8L", "VP8X", "-Y 16384 +X 1", "\n\n"]


func seeds() -> Array[PackedByteArray]:
	var image := Image.create(3, 2, false, Image.FORMAT_RGB8)
	var files: Array[PackedByteArray] = [
		image.save_png_to_buffer(),
		image.save_jpg_to_buffer(),
		image.save_webp_to_buffer(),
		image.save_exr_to_buffer(),
		HDR.to_ascii_buffer(),
		image.save_webp_to_buffer(true, 0.5),
	]
	var found: Array[PackedByteArray] = []
	for i in files.size():
		found.append(PackedByteArray([i % KINDS.size()]) + files[i])
	return found


func read(path: String) -> FuzzAnswer:
	var answer := FuzzAnswer.new()
	var bytes := FileAccess.get_file_as_bytes(path)
	var kind := KINDS[bytes[0] % KINDS.size()] if not bytes.is_empty() else KINDS[0]
	var named := "%s.%s" % [path, kind]
	var file := FileAccess.open(named, FileAccess.WRITE)
	file.store_buffer(bytes.slice(1))
	file.close()
	var size := PictureSize.of_file(named)
	answer.demand((size.x > 0) == (size.y > 0) and size.x >= 0, "a size or none")
	var fault := BackgroundPicture.fault(named)
	if not fault.is_empty():
		answer.complain([kind + ": " + fault], "")
		return answer
	answer.demand(maxi(size.x, size.y) <= BackgroundPicture.LARGEST_SIDE, "a side in its limits")
	return answer
