# SPDX-License-Identifier: MIT
extends GutTest
## Small files are there whole, the old or the new, whatever interrupts their writing.

var _folder: ScratchFolder
var _file: String


func before_each() -> void:
	# The former one first takes its files along.
	_folder = null
	_folder = ScratchFolder.new("atomic")
	_file = _folder.file("a.json")


func _is_whole(text: String) -> bool:
	return text.ends_with("}")


func _read() -> String:
	return AtomicFile.read(_file, _is_whole)


func test_what_is_written_is_read() -> void:
	for text: String in ["{one}", "{zwei: äöü € 𝄞}", "{}"]:
		assert_eq(AtomicFile.write(_file, text), OK)
		assert_eq(_read(), text)
		assert_false(FileAccess.file_exists(_file + AtomicFile.NEW))


func test_nothing_there_is_empty() -> void:
	assert_eq(_read(), "")


func test_a_damaged_file_gives_way_to_the_former_one() -> void:
	AtomicFile.write(_file, "{one}")
	AtomicFile.write(_file, "{two}")
	for damage: String in ["", "{tw", "\u0001\u0002"]:
		_folder.write_text("a.json", damage)
		assert_eq(_read(), "{one}", "after '%s'" % damage)
	DirAccess.remove_absolute(_file)
	assert_eq(_read(), "{one}", "when it is missing")


func test_a_kill_between_the_two_renamings_keeps_the_new_text() -> void:
	AtomicFile.write(_file, "{one}")
	_folder.write_text("a.json.new", "{two}")
	DirAccess.rename_absolute(_file, _file + AtomicFile.FORMER)
	assert_eq(_read(), "{two}")


func test_a_kill_while_writing_keeps_the_old_text() -> void:
	AtomicFile.write(_file, "{one}")
	_folder.write_text("a.json.new", "{tw")
	assert_eq(_read(), "{one}")
	DirAccess.remove_absolute(_file)
	assert_eq(_read(), "", "a first text that was never finished")
	AtomicFile.write(_file, "{three}")
	assert_eq(_read(), "{three}")


func test_the_former_file_is_one_that_has_rested() -> void:
	for text: String in ["{one}", "{two}", "{three}", "{four}"]:
		AtomicFile.write(_file, text)
	var former := FileAccess.get_file_as_string(_file + AtomicFile.FORMER)
	assert_eq(former, "{one}", "not one that may not have reached the disk")


func test_a_folder_that_is_missing_is_made() -> void:
	var deeper := _folder.file("deeper") + "/b.json"
	assert_eq(AtomicFile.write(deeper, "{}"), OK)
	AtomicFile.remove(deeper)
	DirAccess.remove_absolute(deeper.get_base_dir())


func test_what_cannot_be_written_is_told_and_leaves_the_rest_alone() -> void:
	AtomicFile.write(_file, "{one}")
	DirAccess.make_dir_absolute(_file + AtomicFile.NEW)
	assert_ne(AtomicFile.write(_file, "{two}"), OK)
	DirAccess.remove_absolute(_file + AtomicFile.NEW)
	assert_eq(_read(), "{one}")


func test_bytes_that_are_no_text() -> void:
	for bytes: Array in [[0xff], [0x41, 0], [0xe2, 0x41, 0x41], [0xe2, 0x82], [0x80], [0xc0, 0x80]]:
		assert_eq(BoundedText.text_of(PackedByteArray(bytes)), "", str(bytes))
	assert_eq(BoundedText.text_of("aä€𝄞".to_utf8_buffer()), "aä€𝄞")
