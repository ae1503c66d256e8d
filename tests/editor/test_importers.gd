# SPDX-License-Identifier: MIT
@tool
extends "editor_case.gd"
## Tables of stars in CSV become catalogues where the developer says so; the addon's own files are
## resources.

const IMPORTER: String = '[remap]\n\nimporter="blackhole_sky.star_csv"\n'
const GOOD: String = "ra_deg,dec_deg,vmag,name\n10,20,1.5,A\n30,-40,0.5,B\n50,60,3,C\n"
const BAD: String = "ra_deg,dec_deg,vmag\n10,20,1.5\n30,140,0.5\n"


func test_a_good_table_is_imported() -> void:
	await switch_plugin(true)
	await _import("res://good.csv", GOOD)
	var stars := load("res://good.csv") as StarCatalogue
	expect(stars != null, "it is a StarCatalogue")
	if stars != null:
		expect_equal(stars.get_star_count(), 3, "stars")
		expect_equal(stars.get_star_name(0), "B", "the brightest")
	var kind := EditorInterface.get_resource_filesystem().get_file_type("res://good.csv")
	expect_equal(kind, "StarCatalogue", "what the file system dock shows")


func test_a_bad_table_is_refused() -> void:
	await switch_plugin(true)
	await _import("res://bad.csv", BAD)  # the log must have file and line
	expect(load("res://bad.csv") == null, "there is no catalogue")


func test_csv_stays_a_translation_by_default() -> void:
	await switch_plugin(true)
	_write("res://words.csv", "keys,en,de\nHELLO,Hello,Hallo\n")
	var files := EditorInterface.get_resource_filesystem()
	files.scan()
	await until(
		func() -> bool: return FileAccess.file_exists("res://words.csv.import"), "the import"
	)
	await scanned()
	var import := ConfigFile.new()
	import.load("res://words.csv.import")
	expect_equal(import.get_value("remap", "importer"), "csv_translation", "importer")


func test_own_files_are_resources() -> void:
	var files := EditorInterface.get_resource_filesystem()
	var data := "res://addons/blackhole_sky/data/"
	expect_equal(files.get_file_type(data + "schwarzschild.lut"), "LensingTable", "the table")
	expect_equal(files.get_file_type(data + "hipparcos.stars"), "StarCatalogue", "the stars")


func _import(path: String, text: String) -> void:
	_write(path, text)
	_write(path + ".import", IMPORTER)
	var files := EditorInterface.get_resource_filesystem()
	files.scan()
	await frames(2)
	await scanned()


func _write(path: String, text: String) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(text)
	file.close()
