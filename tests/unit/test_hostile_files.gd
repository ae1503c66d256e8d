# SPDX-License-Identifier: MIT
extends GutTest
## Files of four gigabytes, and small ones that announce more than they have: refused at once, by
## name, and without memory for them.

const FOUR_GIGABYTES: int = 1 << 32
const MOST_MSEC: int = 100
const MOST_MEMORY: int = 2 << 20
const FIRST_LINE: String = "hip,name,ra_deg,dec_deg,vmag"
const MOST_PEAK_KB: int = 8192

var _folder := ScratchFolder.new("hostile")


func test_catalogues_of_four_gigabytes() -> void:
	var stars := StarCatalogue.new()
	for start: String in ["", "ra_deg,dec_deg,vmag\n"]:
		for file: String in ["huge.stars", "huge.csv"]:
			var path := _sparse(file, start.to_utf8_buffer(), FOUR_GIGABYTES)
			_expect_cheap(func() -> String: return _refusal(stars, path), path)
	# Within the limit, but nothing in it.
	for file: String in ["void.stars", "void.csv"]:
		var path := _sparse(file, [], 2000000000)
		_expect_cheap(func() -> String: return _refusal(stars, path), path)
	assert_eq(stars.get_star_count(), 0)


func test_a_catalogue_whose_header_lies() -> void:
	var header := FileAccess.get_file_as_bytes("res://addons/blackhole_sky/data/hipparcos.stars")
	header.resize(36)
	for at: int in [12, 16, 20]:
		header.encode_u32(at, 0xFFFFFFFF)
	var stars := StarCatalogue.new()
	for size: int in [36, 2000000000]:
		var path := _sparse("lie.stars", header, size)
		_expect_cheap(func() -> String: return _refusal(stars, path), path)


func test_lensing_tables() -> void:
	var table := LensingTable.new()
	var header := FileAccess.get_file_as_bytes("res://addons/blackhole_sky/data/schwarzschild.lut")
	header.resize(72)
	for size: int in [72, 16000000, FOUR_GIGABYTES]:
		var path := _sparse("huge.lut", header, size)
		_expect_cheap(
			func() -> String:
				assert_ne(table.load_file(path), OK)
				assert_push_error(path)
				return table.get_error_message(),
			path
		)


func test_text_files() -> void:
	var path := _sparse("huge.txt", "{".to_utf8_buffer(), FOUR_GIGABYTES)
	_expect_cheap(func() -> String: return ShotSpec.from_file(path).error, path)
	_expect_cheap(func() -> String: return KioskConfig.from_file(path).complaints[0], path)
	_expect_cheap(func() -> String: return ConstellationFigures.load_file(path).error, path)
	_expect_cheap(func() -> String: return StarNames.load_file(path).error, path)
	_expect_cheap(
		func() -> String:
			var faults: Array[String] = []
			SettingsFile.read(path, faults)
			return faults[0],
		"huge.txt"
	)
	_sparse(Heartbeat.FILE_NAME, [], FOUR_GIGABYTES)
	_expect_cheap(func() -> String: return str(Heartbeat.read(_folder.path)), "{")
	var log_file := _sparse("visits.csv", "number\n".to_utf8_buffer(), FOUR_GIGABYTES)
	var lines := RotatingLog.new(log_file, 1000, 1)
	_expect_cheap(func() -> String: return "last: " + lines.get_last_line(), "last")


func test_a_quote_without_end() -> void:
	var path := _folder.write_text("open.csv", FIRST_LINE + '\n1,"' + "\n".repeat(100000))
	_expect_cheap(func() -> String: return StarNames.load_file(path).error, path)
	path = _folder.write_text("open.csv", FIRST_LINE + "\n" + '"'.repeat(100000))
	_expect_cheap(func() -> String: return StarNames.load_file(path).error, path)


func test_lists_of_thousands() -> void:
	var items: Array = range(5000)
	assert_eq(JsonKinds.repeated(items + [7.0, true, "7", null]), PackedInt32Array([5000]))
	var lists: Array = [[1], {"a": 1, "b": 2}, [1.0], [2], {"b": 2, "a": 1.0}, "[1.0]"]
	assert_eq(JsonKinds.repeated(lists), PackedInt32Array([2, 4]))
	for given: Array in [items, items.map(func(item: int) -> Array: return [item])]:
		var text := '{"start_by": %s}' % JSON.stringify(given)
		var path := _folder.write_text("kiosk.json", text)
		var begun := Time.get_ticks_msec()
		assert_string_contains(KioskConfig.from_file(path).complaints[0], path)
		assert_lt(Time.get_ticks_msec() - begun, 2000, "comparing all with all took minutes")


func test_json_deep_in_itself() -> void:
	for depth: int in [70, 1000, 200000]:
		var path := _folder.write_text("deep.json", '{"stars":' + "[".repeat(depth))
		_expect_cheap(func() -> String: return ShotSpec.from_file(path).error, path)
		var closed := "[".repeat(depth) + "]".repeat(depth)
		path = _folder.write_text("deep.json", '{"position_rs":%s}' % closed)
		_expect_cheap(func() -> String: return ShotSpec.from_file(path).error, "deep")


func test_pictures_that_announce_what_they_have_not() -> void:
	var image := Image.create(3, 2, false, Image.FORMAT_RGB8)
	var png := image.save_png_to_buffer()
	var exr := image.save_exr_to_buffer()
	var window := _find(exr, "dataWindow") + 10 + 1 + 6 + 4
	var large := _with_u32(_with_u32(png, 16, 0x00400000), 20, 0x00400000)
	var huge := _with_u32(_with_u32(png, 16, 0x00000100), 20, 0x00000100)
	var files: Dictionary[String, PackedByteArray] = {
		"large.png": large,
		"huge.png": huge,
		"large.exr": _with_u32(_with_u32(exr, window + 8, 16000), window + 12, 16000),
		"negative.exr": _with_u32(exr, window + 8, 0xFFFFFF00),
		"large.hdr": "#?RADIANCE\n\n-Y 16384 +X 16384\n".to_ascii_buffer(),
		"named_wrongly.png": exr,
		"empty.jpg": PackedByteArray(),
	}
	for file: String in files:
		var path := _folder.write_bytes(file, files[file])
		_expect_cheap(func() -> String: return BackgroundPicture.from_file(path).error, path)
	var sparse := _sparse("sparse.png", png, FOUR_GIGABYTES)
	_expect_cheap(func() -> String: return BackgroundPicture.from_file(sparse).error, sparse)


func test_pictures_as_they_should_be() -> void:
	var image := Image.create(5, 3, false, Image.FORMAT_RGB8)
	var lossy := image.save_webp_to_buffer(true, 0.5)
	var files: Dictionary[String, PackedByteArray] = {
		"a.png": image.save_png_to_buffer(),
		"b.JPG": image.save_jpg_to_buffer(),
		"c.webp": image.save_webp_to_buffer(),
		"d.webp": lossy,
		"e.exr": image.save_exr_to_buffer(),
	}
	for file: String in files:
		var path := _folder.write_bytes(file, files[file])
		assert_eq(PictureSize.of_file(path), Vector2i(5, 3), file)
		var picture := BackgroundPicture.from_file(path)
		assert_eq(picture.error, "", file)
		assert_eq(picture.image.get_size(), Vector2i(5, 3), file)
	var radiance := _folder.write_text("f.hdr", "#?RADIANCE\nA=1\n\n-Y 3 +X 5\n")
	assert_eq(PictureSize.of_file(radiance), Vector2i(5, 3))


func _sparse(file_name: String, start: PackedByteArray, size: int) -> String:
	var path := _folder.write_bytes(file_name, start)
	var file := FileAccess.open(path, FileAccess.READ_WRITE)
	file.resize(size)
	return path


func _refusal(stars: StarCatalogue, path: String) -> String:
	assert_ne(stars.load_file(path), OK)
	assert_push_error(path)
	return stars.get_error_message()


## The refusal comes at once, names a word and costs no memory: neither the engine's nor, which
## counts what libraries take, the process's. Of three tries the quickest counts: the machine may
## be busy.
func _expect_cheap(refusal: Callable, word: String) -> void:
	var took := 1 << 30
	for i in 3:
		if took >= MOST_MSEC:
			took = mini(took, _time_of(refusal, word))
	assert_lt(took, MOST_MSEC, word)


func _time_of(refusal: Callable, word: String) -> int:
	_reset_peak()
	var memory := OS.get_static_memory_usage()
	var peak := _peak_kb()
	var begun := Time.get_ticks_msec()
	var message: String = refusal.call()
	var took := Time.get_ticks_msec() - begun
	assert_string_contains(message, word)
	assert_lt(OS.get_static_memory_usage() - memory, MOST_MEMORY, message)
	assert_lt(_peak_kb() - peak, MOST_PEAK_KB, message)
	return took


# Linux tells the most memory that a process has had, since it was last told to forget.
func _reset_peak() -> void:
	var file := FileAccess.open("/proc/self/clear_refs", FileAccess.WRITE)
	if file != null:
		file.store_string("5")


func _peak_kb() -> int:
	var file := FileAccess.open("/proc/self/status", FileAccess.READ)
	while file != null and not file.eof_reached():
		var line := file.get_line()
		if line.begins_with("VmHWM:"):
			return line.get_slice(":", 1).to_int()
	return 0


func _find(bytes: PackedByteArray, word: String) -> int:
	for at in bytes.size():
		if bytes.slice(at, at + word.length()) == word.to_ascii_buffer():
			return at
	return -1


func _with_u32(bytes: PackedByteArray, at: int, number: int) -> PackedByteArray:
	var changed := bytes.duplicate()
	changed.encode_u32(at, number)
	return changed
