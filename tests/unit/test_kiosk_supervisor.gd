# SPDX-License-Identifier: MIT
extends GutTest
## When the supervisor starts, kills and ends, by its policy alone; how it starts the program; what
## it tells.

var _policy: SupervisorPolicy
var _now: float


func before_each() -> void:
	_policy = SupervisorPolicy.new()
	_now = 0.0


# Lets the program live for so long, with its signs of life.
func _live(seconds: float) -> void:
	_policy.note_start(_now)
	var ends := _now + seconds
	while _now < ends:
		_now += 1.0
		_policy.note_beat(_now)
		assert_eq(_policy.advise(_now), SupervisorPolicy.Action.NONE)


# How long it then takes until it is to be started.
func _await_start() -> float:
	var from := _now
	while _policy.advise(_now) != SupervisorPolicy.Action.START:
		_now += 0.25
		if _now - from > 1000.0:
			break
	return _now - from


func test_a_program_knows_when_its_supervisor_is_gone() -> void:
	assert_false(SupervisorWatch.is_gone([]), "there was none")
	if not DirAccess.dir_exists_absolute("/proc/self"):
		return
	assert_false(SupervisorWatch.is_gone(["--kiosk", SupervisorWatch.argument()]))
	assert_true(SupervisorWatch.is_gone([SupervisorWatch.ARGUMENT + "99999999"]))


func test_starts_at_once_and_leaves_a_healthy_program_alone() -> void:
	assert_eq(_policy.advise(0.0), SupervisorPolicy.Action.START)
	_live(5000.0)
	assert_eq(_policy.restarts, 0)


func test_the_operator_ends_it_and_nobody_else() -> void:
	_live(20.0)
	_policy.note_end(0, false, _now)
	assert_ne(
		_policy.advise(_now + 100.0), SupervisorPolicy.Action.END, "left without being asked to"
	)
	_now += 100.0
	_live(20.0)
	_policy.note_end(0, true, _now)
	assert_eq(_policy.advise(_now), SupervisorPolicy.Action.END)
	assert_eq(_policy.advise(_now + 1e6), SupervisorPolicy.Action.END)


func test_planned_ends_are_followed_by_a_start_at_once() -> void:
	for status in ExitStatus.PLANNED:
		_live(30.0)
		_policy.note_end(status, false, _now)
		assert_eq(_await_start(), 0.0, str(status))
	assert_eq(_policy.failures, 0)


func test_waits_double_up_to_the_longest() -> void:
	var waits: Array[float] = []
	for i in 9:
		_live(3.0)
		_policy.note_end(139, false, _now)
		waits.append(_await_start())
	assert_eq(waits, [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 60.0, 60.0, 60.0])
	assert_eq(_policy.restarts, 8)


func test_failures_are_forgotten_after_a_time_of_health() -> void:
	for i in 5:
		_live(3.0)
		_policy.note_end(139, false, _now)
		_await_start()
	_live(_policy.well_seconds + 1.0)
	_policy.note_end(139, false, _now)
	assert_eq(_await_start(), 1.0)


func test_a_planned_end_that_comes_at_once_counts_as_a_failure() -> void:
	var last := 0.0
	for i in 4:
		_live(2.0)
		_policy.note_end(ExitStatus.DAILY, false, _now)
		var wait := _await_start()
		assert_gt(wait, last)
		last = wait
	_live(2.0)
	_policy.note_end(ExitStatus.RUNTIME_MISSING, false, _now)
	assert_eq(_await_start(), 0.0, "that one has waited itself")


func test_one_that_hangs_is_killed_once_and_started_again() -> void:
	_live(30.0)
	var kills := 0
	for i in 400:
		_now += 0.25
		kills += 1 if _policy.advise(_now) == SupervisorPolicy.Action.KILL else 0
		if kills == 1 and i > 200:
			break
	assert_eq(kills, 1)
	_policy.note_end(ExitStatus.DAILY, false, _now)
	assert_string_contains(_policy.last_event, "hung")
	assert_eq(_policy.failures, 1, "what a killed one ends with means nothing")
	assert_eq(_await_start(), 1.0)


func test_a_start_may_take_longer() -> void:
	_policy.note_start(0.0)
	assert_eq(_policy.advise(_policy.hang_seconds + 5.0), SupervisorPolicy.Action.NONE)
	assert_eq(_policy.advise(_policy.start_seconds + 1.0), SupervisorPolicy.Action.KILL)
	assert_string_contains(_policy.last_event, "did not come up")


func test_a_program_that_cannot_be_started_is_tried_again() -> void:
	_policy.note_no_start(0.0)
	assert_eq(_await_start(), 1.0)
	_policy.note_no_start(_now)
	assert_eq(_await_start(), 2.0)


func test_the_command() -> void:
	var user: PackedStringArray = [
		"--supervise",
		"--kiosk-config=/k.json",
		"--engine=--max-fps",
		"--engine=30",
		"--time-scale=2"
	]
	var in_engine := ProgramCommand.arguments(user, "/sky", true)
	var expected: PackedStringArray = ["--path", "/sky", "--max-fps", "30", "--xr-mode", "on"]
	expected.append_array([ProgramCommand.SCENE, "--", "--kiosk", "--kiosk-config=/k.json"])
	expected.append("--time-scale=2")
	assert_eq(in_engine, expected)
	var exported := ProgramCommand.arguments(["--supervise"], "", false)
	assert_eq(exported, PackedStringArray(["--", "--kiosk"]))
	var own: PackedStringArray = ["--engine=--xr-mode", "--engine=off"]
	assert_eq(ProgramCommand.arguments(own, "", true).count("--xr-mode"), 1)
	assert_true(ResourceLoader.exists(ProgramCommand.SCENE))


func test_the_health_file() -> void:
	var folder := ScratchFolder.new("kiosk_health")
	_live(5.0)
	_policy.note_end(139, false, _now)
	var health := HealthFile.new(folder.path, 1e18)
	health.write("waiting", {"step": "visit", "last_visit": "7,x"}, _policy, "no room")
	var text := FileAccess.get_file_as_string(folder.file(HealthFile.FILE_NAME))
	var told: Dictionary = JSON.parse_string(text)
	assert_eq(told["state"], "waiting")
	assert_eq(told["last_visit"], "7,x")
	assert_eq(told["log_fault"], "no room")
	assert_eq(told["low_disk"], true)
	assert_string_contains(str(told["last_event"]), "139")
	assert_eq(told["version"], ProgramVersion.text())


func test_statuses_have_names_of_their_own() -> void:
	var names: Dictionary[String, bool] = {}
	for status: int in [0, 75, 76, 77, 78, 79, 139]:
		names[ExitStatus.describe(status, true)] = true
	assert_eq(names.size(), 7)


func test_a_program_is_told_how_to_ask_for_memory_where_its_operator_has_not() -> void:
	var variables := SteadyMemory.VARIABLES.keys()
	var kept := variables.map(OS.get_environment)
	OS.set_environment("MALLOC_MMAP_THRESHOLD_", "1")
	OS.unset_environment("MALLOC_TRIM_THRESHOLD_")
	SteadyMemory.prepare()
	assert_eq(OS.get_environment("MALLOC_MMAP_THRESHOLD_"), "1", "the operator's own")
	var told := OS.get_environment("MALLOC_TRIM_THRESHOLD_").to_int()
	assert_eq(told > 0, OS.has_feature("linux"))
	for i in variables.size():
		if kept[i].is_empty():
			OS.unset_environment(variables[i])
		else:
			OS.set_environment(variables[i], kept[i])
