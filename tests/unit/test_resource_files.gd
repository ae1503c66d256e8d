# SPDX-License-Identifier: MIT
extends GutTest
## Tables and catalogues are Godot's resources: loaded and saved by path, on threads too; a damaged
## file is refused with its name.

const TABLE: String = "res://addons/blackhole_sky/data/schwarzschild.lut"
const STARS: String = "res://addons/blackhole_sky/data/hipparcos.stars"

var _folder := ScratchFolder.new("resource_files")


func test_load(
	# file, class
	p: Array = use_parameters([[TABLE, "LensingTable"], [STARS, "StarCatalogue"]])
) -> void:
	var path: String = p[0]
	assert_true(ResourceLoader.exists(path))
	var found := load(path)
	assert_true(found.is_class(str(p[1])))
	assert_eq(found.resource_path, path)
	assert_same(load(path), found, "the engine keeps it while it is in use")


func test_load_on_a_thread() -> void:
	ResourceLoader.load_threaded_request(STARS, "", true, ResourceLoader.CACHE_MODE_IGNORE)
	var stars: StarCatalogue = ResourceLoader.load_threaded_get(STARS)
	assert_eq(stars.get_star_count(), 118217)
	ResourceLoader.load_threaded_request(TABLE, "", true, ResourceLoader.CACHE_MODE_IGNORE)
	var table: LensingTable = ResourceLoader.load_threaded_get(TABLE)
	assert_true(table.is_ready())


func test_a_damaged_file_is_named(ending: Variant = use_parameters(["lut", "stars"])) -> void:
	var path := _folder.write_text("damaged.%s" % ending, "nothing of the kind")
	assert_null(load(path))
	assert_push_error("damaged.%s" % ending)
	assert_engine_error("Failed loading resource")


func test_a_saved_table_is_the_same() -> void:
	var path := _folder.file("saved.lut")
	assert_eq(ResourceSaver.save(load(TABLE), path), OK)
	assert_eq(FileAccess.get_md5(path), FileAccess.get_md5(TABLE))


func test_saved_stars_are_the_same() -> void:
	var path := _folder.file("saved.stars")
	assert_eq(ResourceSaver.save(load(STARS), path), OK)
	assert_eq(FileAccess.get_md5(path), FileAccess.get_md5(STARS))


func test_stars_that_cannot_be_written() -> void:
	var stars := StarCatalogue.new()
	assert_eq(stars.save_file("user://no/such/folder/x.stars"), ERR_FILE_CANT_WRITE)
	assert_push_error("x.stars")


func test_a_table_without_file_is_empty_again() -> void:
	var table := LensingTable.new()
	watch_signals(table)
	table.source_file = TABLE
	assert_true(table.is_ready())
	table.source_file = ""
	assert_false(table.is_ready())
	assert_null(table.get_inverse_texture())
	assert_signal_emit_count(table, "changed", 2)
