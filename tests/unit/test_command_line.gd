# SPDX-License-Identifier: MIT
extends GutTest
## Which words of a command line are the program's own.


func test_own_words_need_no_dashes_before_them() -> void:
	var engine := PackedStringArray(["--self-test=a.json", "--verbose", "res://a.tscn", "--kiosk"])
	var user := PackedStringArray(["--few-stars"])
	assert_eq(
		CommandLine.own(engine, user),
		PackedStringArray(["--self-test=a.json", "--kiosk", "--few-stars"])
	)


func test_the_engines_words_are_left_to_it() -> void:
	var engine := PackedStringArray(["--headless", "--few-stars", "self-test", "--self-tests"])
	assert_eq(CommandLine.own(engine, []), PackedStringArray())


func test_values() -> void:
	var arguments := PackedStringArray(["--kiosk", "--kiosk-config=/a b.json", "--kiosk-config=c"])
	assert_eq(CommandLine.value(arguments, "--kiosk-config="), "/a b.json")
	assert_eq(CommandLine.value(arguments, "--seed="), "")
