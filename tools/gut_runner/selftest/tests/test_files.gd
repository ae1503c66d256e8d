# SPDX-License-Identifier: MIT
extends GutTest
## Files.

const NOTHING := "user://runner_no_such_file"
const EMPTY := "user://runner_empty_file"
const FULL := "user://runner_full_file"


func before_all() -> void:
	FileAccess.open(EMPTY, FileAccess.WRITE).close()
	var file: FileAccess = FileAccess.open(FULL, FileAccess.WRITE)
	file.store_string("content")
	file.close()


func after_all() -> void:
	DirAccess.remove_absolute(EMPTY)
	DirAccess.remove_absolute(FULL)


func test_pass_files() -> void:
	assert_file_exists(EMPTY)
	assert_file_does_not_exist(NOTHING)
	assert_file_empty(EMPTY)
	assert_file_not_empty(FULL)


func test_fail_file_exists() -> void:
	assert_file_exists(NOTHING)


func test_fail_file_does_not_exist() -> void:
	assert_file_does_not_exist(FULL)


func test_fail_file_empty() -> void:
	assert_file_empty(FULL)


func test_fail_file_empty_absent() -> void:
	assert_file_empty(NOTHING)


func test_fail_file_not_empty() -> void:
	assert_file_not_empty(EMPTY)


func test_fail_file_not_empty_absent() -> void:
	assert_file_not_empty(NOTHING)
