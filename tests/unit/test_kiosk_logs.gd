# SPDX-License-Identifier: MIT
extends GutTest
## What the exhibit writes down: logs that rotate and survive a full disk, visits without gaps, the
## sign of life.

var _folder: ScratchFolder


func before_each() -> void:
	_folder = ScratchFolder.new("kiosk_logs")


func after_each() -> void:
	_folder = null


func _text(file_name: String) -> String:
	return FileAccess.get_file_as_string(_folder.file(file_name))


func _visit(journal: VisitLog, how: String = "idle") -> VisitRecord:
	var record := VisitRecord.new()
	record.language = "de"
	record.mode = "screen"
	journal.begin(record)
	record.end = how
	journal.finish(record)
	return record


func test_old_logs_give_way() -> void:
	var journal := RotatingLog.new(_folder.file("a.log"), 100, 2, "head")
	for i in 30:
		journal.add("line %02d %s" % [i, "x".repeat(20)])
	assert_eq(journal.fault, "")
	assert_string_contains(_text("a.log"), "line 29")
	for file_name: String in ["a.log", "a.log.1", "a.log.2"]:
		assert_true(_text(file_name).begins_with("head\nline"), file_name)
		assert_between(_text(file_name).length(), 30, 100, file_name)
	assert_false(FileAccess.file_exists(_folder.file("a.log.3")))
	assert_string_contains(journal.get_last_line(), "line 29")


func test_lines_wait_until_there_is_room() -> void:
	# A folder in the log's place stands for a disk that takes nothing.
	var path := _folder.file("b.log")
	DirAccess.make_dir_absolute(path)
	var journal := RotatingLog.new(path, 1000, 2)
	journal.add("first")
	journal.add("second")
	assert_string_contains(journal.fault, "b.log")
	DirAccess.remove_absolute(path)
	journal.add("third")
	assert_eq(journal.fault, "")
	assert_eq(_text("b.log"), "first\nsecond\nthird\n")


func test_waiting_lines_do_not_fill_the_memory() -> void:
	var path := _folder.file("c.log")
	DirAccess.make_dir_absolute(path)
	var journal := RotatingLog.new(path, 1000000, 2)
	for i in RotatingLog.MOST_WAITING + 5:
		journal.add(str(i))
	DirAccess.remove_absolute(path)
	journal.flush()
	assert_eq(_text("c.log").get_slice("\n", 0), "5")


func test_visits_are_numbered_through_restarts() -> void:
	for i in 3:
		var journal := VisitLog.new(_folder.path, 10000, 3)
		_visit(journal)
		_visit(journal)
		assert_eq(journal.get_last_number(), 2 * i + 2)
		assert_eq(journal.get_count_today(), 2 * i + 2)
	var lines := _text("visits.csv").split("\n", false)
	assert_eq(lines[0], VisitRecord.HEAD)
	assert_eq(lines.size(), 7)
	for i in range(1, 7):
		assert_eq(lines[i].get_slice(",", 0), str(i))
		assert_eq(lines[i].get_slice_count(","), VisitRecord.HEAD.get_slice_count(","))


func test_a_visit_that_was_cut_is_told_at_the_next_start() -> void:
	var journal := VisitLog.new(_folder.path, 10000, 3)
	_visit(journal)
	var record := VisitRecord.new()
	record.language = "en"
	journal.begin(record)
	var seen := Time.get_unix_time_from_system() + 77.0
	journal = VisitLog.new(_folder.path, 10000, 3, seen)
	var cut := journal.lines.get_last_line().split(",")
	assert_eq(cut[0], "2")
	assert_eq(cut[-1], VisitRecord.CUT)
	assert_between(cut[2].to_int(), 75, 79)
	assert_eq(cut[3], "en")
	assert_eq(_visit(journal).number, 3)
	journal = VisitLog.new(_folder.path, 10000, 3, seen)
	assert_eq(_text("visits.csv").count(VisitRecord.CUT), 1, "once")


func test_a_kill_between_line_and_state_tells_nothing_twice() -> void:
	var journal := VisitLog.new(_folder.path, 10000, 3)
	var record := VisitRecord.new()
	journal.begin(record)
	var open := _text(VisitLog.STATE_NAME)
	record.end = "time"
	journal.finish(record)
	_folder.write_text(VisitLog.STATE_NAME, open)
	journal = VisitLog.new(_folder.path, 10000, 3)
	assert_eq(journal.lines.get_last_line().get_slice(",", 11), "time")
	assert_eq(journal.get_last_number(), 1)


func test_a_damaged_state_is_no_reason_to_stop() -> void:
	_visit(VisitLog.new(_folder.path, 10000, 3))
	for broken: String in ["", "{", '{"last": "many", "open": [1], "today": 3}', "[]"]:
		for ending: String in ["", AtomicFile.FORMER]:
			_folder.write_text(VisitLog.STATE_NAME + ending, broken)
		assert_eq(VisitLog.new(_folder.path, 10000, 3).get_last_number(), 1, broken)


func test_the_sign_of_life() -> void:
	assert_eq(Heartbeat.read(_folder.path), {})
	var heartbeat := Heartbeat.new(_folder.path)
	heartbeat.beat_now({"step": "attract"})
	var first := Heartbeat.read(_folder.path)
	assert_eq(first["step"], "attract")
	assert_eq(first["pid"], float(OS.get_process_id()))
	assert_eq(FileAccess.get_size(_folder.file(Heartbeat.FILE_NAME)), Heartbeat.SIZE)
	heartbeat.beat({"step": "visit"})
	heartbeat.wait()
	var second := Heartbeat.read(_folder.path)
	assert_eq(second["step"], "visit")
	assert_gt(second["beat"], first["beat"])
	_folder.write_text(Heartbeat.FILE_NAME, '{"step": "vi')
	assert_eq(Heartbeat.read(_folder.path), {}, "half of one says nothing")


func test_a_full_disk_does_not_stop_the_sign_of_life() -> void:
	var heartbeat := Heartbeat.new(_folder.path)
	heartbeat.beat_now({"step": "attract"})
	# No new file can be made: a folder is in its place.
	DirAccess.make_dir_absolute(_folder.file(Heartbeat.FILE_NAME + ".new"))
	heartbeat.beat_now({"step": "visit"})
	assert_eq(Heartbeat.read(_folder.path)["step"], "visit")
	DirAccess.remove_absolute(_folder.file(Heartbeat.FILE_NAME + ".new"))


func test_errors_are_kept_and_floods_are_not() -> void:
	var errors := RecentErrors.new()
	for i in 100:
		errors._log_error("f", "res://a.gd", 3, "", "the same", false, 0, [])
	for i in 20:
		errors._log_error("f", "res://a.gd", i, "code %d" % i, "", false, 0, [])
	assert_eq(errors.get_count(), 120)
	assert_eq(errors.get_texts().size(), RecentErrors.MOST)
	assert_eq(errors.get_texts()[0], "code 19 (a.gd:19)")
	assert_eq(errors.take_fresh().size(), RecentErrors.MOST)
	assert_eq(errors.take_fresh().size(), 0)


func test_pictures_are_counted() -> void:
	var frames := FrameCount.new()
	for i in 120:
		frames.add(1.0 / 60.0, 1.0 / 60.0)
	assert_eq(frames.least_fps, 60)
	assert_eq(frames.late, 0)
	for i in 20:
		frames.add(0.1, 1.0 / 60.0)
	assert_eq(frames.least_fps, 10)
	assert_eq(frames.late, 20)
	frames.add(0.1, 0.0)
	assert_eq(frames.late, 20, "where nobody knows how long a picture takes")
