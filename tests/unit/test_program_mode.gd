# SPDX-License-Identifier: MIT
extends GutTest
## The command line decides what the program is.

var _cases: Array = (
	ParameterFactory
	. named_parameters(
		["arguments", "headset", "kind"],
		[
			[[], false, ProgramMode.Kind.DESKTOP],
			[[], true, ProgramMode.Kind.HEADSET],
			[["--headset"], false, ProgramMode.Kind.HEADSET],
			[["--kiosk"], true, ProgramMode.Kind.KIOSK],
			[["--kiosk", "--supervise"], false, ProgramMode.Kind.SUPERVISOR],
			[["-x", "--self-test"], true, ProgramMode.Kind.SELF_TEST],
			[["--self-test=a.json"], false, ProgramMode.Kind.SELF_TEST],
			[["--self-tests", "self-test"], false, ProgramMode.Kind.DESKTOP],
		]
	)
)


func test_kinds(p: Variant = use_parameters(_cases)) -> void:
	var arguments := PackedStringArray()
	var listed: Array = p.arguments
	for argument: String in listed:
		arguments.append(argument)
	assert_eq(ProgramMode.of(arguments, bool(p.headset)), p.kind, "%s" % [listed])


func test_every_kind_has_its_scene() -> void:
	for kind: ProgramMode.Kind in ProgramMode.Kind.values():
		assert_true(ResourceLoader.exists(ProgramMode.SCENES[kind]), ProgramMode.SCENES[kind])


func test_the_version_is_the_addons() -> void:
	assert_string_contains(
		FileAccess.get_file_as_string(ProgramVersion.FILE), 'version="%s"' % ProgramVersion.text()
	)
	assert_string_contains(ProgramVersion.text(), ".")
