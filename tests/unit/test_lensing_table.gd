# SPDX-License-Identifier: MIT
extends GutTest
## Lensing tables: read, baked, saved, and refused when damaged.

const COMMITTED: String = "res://addons/blackhole_sky/data/schwarzschild.lut"
const HEADER_BYTES: int = 72
const BAKE_SECONDS: float = 60.0

var _folder := ScratchFolder.new("tables")
var _table: LensingTable


func before_each() -> void:
	_table = LensingTable.new()
	watch_signals(_table)


func test_the_committed_table() -> void:
	assert_false(_table.is_ready())
	assert_eq(_table.load_file(COMMITTED), OK)
	assert_true(_table.is_ready())
	assert_eq(_table.get_error_message(), "")
	assert_signal_emit_count(_table, "changed", 1)
	var values := FileAccess.get_file_as_bytes(COMMITTED).slice(HEADER_BYTES)
	var texels := _table.get_inverse_texels() + _table.get_forward_texels()
	assert_eq(texels.size(), 2 * 4 * 128 * 96)
	for texture: ImageTexture in [_table.get_inverse_texture(), _table.get_forward_texture()]:
		assert_eq(Vector2i(texture.get_size()), Vector2i(128, 96))
	var sky_tables := texels.to_byte_array()
	assert_true(sky_tables == values.slice(0, sky_tables.size()), "the numbers of the file")
	var numbers := values.slice(sky_tables.size()).to_float32_array()
	for texture: ImageTexture in [_table.get_radius_texture(), _table.get_delay_texture()]:
		assert_eq(Vector2i(texture.get_size()), Vector2i(95 * 4 + 1, 2 * (63 * 6 + 1)))
		var texel := texture.get_image().get_pixel(7 * 4, 20 * 6)
		var stored := 4 * (20 * 96 + 7)
		for channel in 4:
			var step: float = [1.0, 4.0, 6.0, 24.0][channel]
			assert_almost_eq(texel[channel] * step, numbers[stored + channel], 1e-6)
		numbers = numbers.slice(4 * 96 * 128)


func test_source_file_loads_and_is_stored() -> void:
	_table.source_file = COMMITTED
	assert_true(_table.is_ready())
	var path := _folder.file("table.tres")
	assert_eq(ResourceSaver.save(_table, path), OK)
	var loaded: LensingTable = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	assert_true(loaded.is_ready())


func test_an_empty_table_has_nothing() -> void:
	assert_false(_table.is_ready())
	assert_false(_table.is_baking())
	assert_null(_table.get_inverse_texture())
	assert_null(_table.get_forward_texture())
	assert_eq(_table.get_inverse_texels().size(), 0)
	assert_eq(_table.get_forward_texels().size(), 0)
	assert_ne(_table.save_file(_folder.file("nothing.lut")), OK)
	assert_push_error("no table yet")
	assert_file_does_not_exist(_folder.file("nothing.lut"))


func test_damaged_tables_are_refused(
	# file size or -1 for all, byte to change or -1, words of the message
	p: Array = use_parameters(
		[
			[0, -1, "no lensing table"],
			[40, -1, "cut off"],
			[HEADER_BYTES, -1, "bytes instead of"],
			[200000, -1, "bytes instead of"],
			[-1, 0, "no lensing table"],
			[-1, 8, "format version"],
			[-1, 16, "header is damaged"],
			[-1, 40, "header is damaged"],
			[-1, 300000, "values are damaged"],
		]
	)
) -> void:
	var bytes := FileAccess.get_file_as_bytes(COMMITTED)
	if p[0] >= 0:
		bytes = bytes.slice(0, p[0])
	if p[1] >= 0:
		bytes[p[1]] ^= 0x15
	var path := _folder.write_bytes("damaged.lut", bytes)
	assert_eq(_table.load_file(path), ERR_FILE_CORRUPT)
	assert_push_error(path)
	for words: String in [path, p[2], "./run bake"]:
		assert_string_contains(_table.get_error_message(), words)
	assert_false(_table.is_ready())
	assert_signal_not_emitted(_table, "changed")


func test_a_missing_file() -> void:
	assert_eq(_table.load_file("res://no/such.lut"), ERR_FILE_CANT_OPEN)
	assert_push_error("res://no/such.lut")
	assert_string_contains(_table.get_error_message(), "bake()")
	assert_false(_table.is_ready())


func test_a_refused_file_leaves_the_table_as_it_was() -> void:
	_table.load_file(COMMITTED)
	var texture := _table.get_inverse_texture()
	_table.load_file(_folder.write_text("text.lut", "no table"))
	assert_push_error("text.lut")
	assert_true(_table.is_ready())
	assert_same(_table.get_inverse_texture(), texture)
	assert_eq(_table.load_file(COMMITTED), OK)
	assert_eq(_table.get_error_message(), "", "a good file clears the message")


func test_save_and_load_round_trip() -> void:
	_table.load_file(COMMITTED)
	var path := _folder.file("copy.lut")
	assert_eq(_table.save_file(path), OK)
	assert_eq(FileAccess.get_md5(path), FileAccess.get_md5(COMMITTED))


func test_a_place_that_cannot_be_written() -> void:
	_table.load_file(COMMITTED)
	assert_ne(_table.save_file("user://no/such/folder/table.lut"), OK)
	assert_push_error("cannot be written")


func test_baking_on_a_worker() -> void:
	_table.bake()
	assert_true(_table.is_baking())
	assert_between(_table.get_bake_progress(), 0.0, 1.0)
	_table.bake()  # a second call changes nothing
	assert_true(await wait_for_signal(_table.bake_finished, BAKE_SECONDS))
	assert_signal_emit_count(_table, "bake_finished", 1)
	assert_signal_emitted_with_parameters(_table, "bake_finished", [true])
	assert_signal_emit_count(_table, "changed", 1)
	assert_false(_table.is_baking())
	assert_eq(_table.get_bake_progress(), 1.0)
	assert_true(_table.is_ready())
	var committed := LensingTable.new()
	committed.load_file(COMMITTED)
	_expect_alike(_table.get_inverse_texture(), committed.get_inverse_texture())
	_expect_alike(_table.get_forward_texture(), committed.get_forward_texture())


func test_a_bake_can_be_given_up() -> void:
	_table.bake()
	_table.cancel_bake()
	assert_true(await wait_for_signal(_table.bake_finished, BAKE_SECONDS))
	assert_signal_emitted_with_parameters(_table, "bake_finished", [false])
	assert_false(_table.is_ready())
	assert_false(_table.is_baking())


func test_a_bake_given_up_keeps_the_table() -> void:
	_table.load_file(COMMITTED)
	_table.bake()
	assert_true(_table.is_ready(), "the old table stays in use while the new one is made")
	_table.cancel_bake()
	assert_true(await wait_for_signal(_table.bake_finished, BAKE_SECONDS))
	assert_true(_table.is_ready())


func test_letting_go_of_a_table_that_bakes(given_up: bool = use_parameters([true, false])) -> void:
	var table := LensingTable.new()
	var watched: WeakRef = weakref(table)
	table.bake()
	if given_up:
		table.cancel_bake()
	table = null
	var gone := func() -> bool: return watched.get_ref() == null
	assert_true(await wait_until(gone, BAKE_SECONDS), "it goes when it is done")


func _expect_alike(a: ImageTexture, b: ImageTexture) -> void:
	var values := a.get_image().get_data().to_float32_array()
	var others := b.get_image().get_data().to_float32_array()
	assert_eq(values.size(), others.size())
	var worst := 0.0
	for i in values.size():
		worst = maxf(worst, absf(values[i] - others[i]))
	assert_lt(worst, 1e-5, "baked here and committed")
