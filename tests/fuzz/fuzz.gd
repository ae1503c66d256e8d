# SPDX-License-Identifier: MIT
extends SceneTree
## Tries a reader with broken files until its time is over:
##
##     godot --headless --path . -s res://tests/fuzz/fuzz.gd -- --target=NAME --folder=DIR
##         [--seconds=N] [--seed=N] [--input=FILE]
##
## Demanded are: no error of the engine or of a script, an answer within seconds, and what the
## target demands. What fails is kept in the folder. With an input that one alone is tried. Exits 1
## when something failed, 2 for a wrong command line.

const SLOW_MSEC: int = 4000
const MOST_FINDINGS: int = 8

var _target: FuzzTarget
var _folder: String
var _seed: int
var _errors := ErrorListener.new()
var _random := RandomNumberGenerator.new()
var _bytes: ByteMutator
var _values: JsonMutator
## Files that led to answers of different kinds.
var _corpus: Array[PackedByteArray] = []
var _kinds: Dictionary[String, int] = {}
var _tries: int = 0
var _findings: int = 0


func _initialize() -> void:
	var arguments := OS.get_cmdline_user_args()
	var name := CommandLine.value(arguments, "--target=")
	_folder = CommandLine.value(arguments, "--folder=")
	var script := "res://tests/fuzz/targets/%s_target.gd" % name
	if _folder.is_empty() or not ResourceLoader.exists(script):
		printerr("fuzz: give --target=NAME and --folder=DIR; targets are in tests/fuzz/targets.")
		quit(2)
		return
	_target = (load(script) as GDScript).new()
	var chosen := CommandLine.value(arguments, "--seed=")
	_seed = chosen.to_int() if chosen.is_valid_int() else randi()
	DirAccess.make_dir_recursive_absolute(_folder)
	await process_frame  # nodes that a target makes are in the tree from now on
	OS.add_logger(_errors)
	var input := CommandLine.value(arguments, "--input=")
	if not input.is_empty():
		_try(FileAccess.get_file_as_bytes(input))
	else:
		_run(name, CommandLine.value(arguments, "--seconds=").to_float())
	OS.remove_logger(_errors)
	quit(1 if _findings > 0 else 0)


func _run(name: String, seconds: float) -> void:
	_random.seed = _seed
	_bytes = ByteMutator.new(_random, _target.words)
	_values = JsonMutator.new(_random)
	print("fuzz %s: seed %d" % [name, _seed])
	for given in _target.seeds() + _regressions(name):
		_try(given)
		_corpus.append(given)
	var begun := Time.get_ticks_msec()
	var told := begun
	while Time.get_ticks_msec() - begun < seconds * 1000.0 and _findings < MOST_FINDINGS:
		_try(_mutant())
		if Time.get_ticks_msec() - told > 60000:
			told = Time.get_ticks_msec()
			print(_status(name))
	print(_status(name))


## Files that once were findings.
func _regressions(name: String) -> Array[PackedByteArray]:
	var found: Array[PackedByteArray] = []
	var folder := "res://tests/fuzz/seeds".path_join(name)
	if not DirAccess.dir_exists_absolute(folder):
		return found
	for file in DirAccess.get_files_at(folder):
		if file.get_extension() != "import":
			found.append(FileAccess.get_file_as_bytes(folder.path_join(file)))
	return found


func _status(name: String) -> String:
	return (
		"fuzz %s: %d executions, %d kinds of answer, %d accepted, %d findings"
		% [name, _tries, _kinds.size(), _kinds.get(FuzzAnswer.ACCEPTED, 0), _findings]
	)


func _mutant() -> PackedByteArray:
	var bytes := _corpus[_random.randi() % _corpus.size()]
	var other := _corpus[_random.randi() % _corpus.size()]
	if _target.is_json and _random.randf() < 0.7:
		var data := JSON.new()
		var other_data := JSON.new()
		if data.parse(BoundedText.text_of(bytes)) == OK:
			other_data.parse(BoundedText.text_of(other))
			bytes = FuzzTarget.json(_values.changed(data.data, other_data.data))
			if _random.randf() < 0.7:
				return bytes
	return _bytes.changed(bytes, other)


func _try(bytes: PackedByteArray) -> void:
	_tries += 1
	# What the mutators made the engine say is nobody's fault.
	_errors.take()
	var path := _folder.path_join(_target.file_name)
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_buffer(bytes)
	file.close()
	var begun := Time.get_ticks_msec()
	var answer := _target.read(path)
	if Time.get_ticks_msec() - begun > SLOW_MSEC and _is_slow_again(path):
		answer.demand(false, "an answer within seconds")
	var said := _errors.take()
	answer.demand(said.is_empty(), "no error: " + " | ".join(said))
	if not answer.broken.is_empty():
		_keep(bytes, answer.broken)
	var kind := answer.kind()
	_kinds[kind] = _kinds.get(kind, 0) + 1
	if _kinds[kind] == 1 and bytes.size() < 20000:
		_corpus.append(bytes)


## On a busy machine anything may take seconds once.
func _is_slow_again(path: String) -> bool:
	for i in 2:
		var begun := Time.get_ticks_msec()
		_target.read(path)
		if Time.get_ticks_msec() - begun < SLOW_MSEC:
			return false
	return true


func _keep(bytes: PackedByteArray, why: String) -> void:
	_findings += 1
	var path := _folder.path_join("finding_%d_%d" % [_seed, _findings])
	print("fuzz: finding (seed %d, try %d): %s\nkept as %s" % [_seed, _tries, why, path])
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_buffer(bytes)
