# SPDX-License-Identifier: MIT
extends "layer_objects.gd"
## Asserts on signals. The object must be watched; most take (object, "name", ...) or
## (object.name, ...).

const SignalWatcher := preload("signal_watcher.gd")

var _watcher: SignalWatcher = SignalWatcher.new()


## What an assert was called with, in one shape.
class Call:
	extends RefCounted

	var object: Object = null
	var signal_name: StringName = &""
	## What follows the signal.
	var rest: Array = []

	func _init(arguments: Array) -> void:
		if arguments[0] is Signal:
			var the_signal: Signal = arguments[0]
			object = the_signal.get_object()
			signal_name = the_signal.get_name()
			rest = arguments.slice(1)
		else:
			object = arguments[0]
			signal_name = str(arguments[1])
			rest = arguments.slice(2)


## Records all signals of an object until the end of the test.
func watch_signals(object: Variant) -> void:
	_watcher.watch(object)


## How often a watched signal was emitted; -1 when it is not watched or does not exist.
func get_signal_emit_count(p1: Variant, p2: Variant = null) -> Variant:
	var what: Call = Call.new([p1, p2])
	if not _watcher.is_watching(what.object) or not what.object.has_signal(what.signal_name):
		return -1
	return _watcher.emissions(what.object, what.signal_name).size()


## The arguments of one emission, the last by default; null when there was none.
func get_signal_parameters(p1: Variant, p2: Variant = null, p3: Variant = -1) -> Variant:
	var what: Call = Call.new([p1, p2, p3])
	var index: int = what.rest[0] if what.rest[0] is int else -1
	return _emission(what, index)


func assert_has_signal(object: Variant, signal_name: Variant, text: Variant = "") -> void:
	var holds: bool = object.has_signal(signal_name)
	_check(holds, "{0} expected to have the signal {1}", [object, signal_name], text)


func assert_signal_emitted(p1: Variant, p2: Variant = "", p3: Variant = "") -> void:
	var what: Call = Call.new([p1, p2, p3])
	if _is_watched(what):
		var emitted: bool = not _watcher.emissions(what.object, what.signal_name).is_empty()
		var values: Array = [what.object, what.signal_name, _watcher.emitted_names(what.object)]
		_check(emitted, "{0} expected to emit {1}; it emitted {2}", values, what.rest[0])


func assert_signal_not_emitted(p1: Variant, p2: Variant = "", p3: Variant = "") -> void:
	var what: Call = Call.new([p1, p2, p3])
	if _is_watched(what):
		var quiet: bool = _watcher.emissions(what.object, what.signal_name).is_empty()
		var values: Array = [what.object, what.signal_name]
		_check(quiet, "{0} expected not to emit {1}", values, what.rest[0])


func assert_signal_emit_count(p1: Variant, p2: Variant, p3: Variant = 0, p4: Variant = "") -> void:
	var what: Call = Call.new([p1, p2, p3, p4])
	if _is_watched(what):
		var count: int = _watcher.emissions(what.object, what.signal_name).size()
		var values: Array = [what.object, what.signal_name, what.rest[0], count]
		var note: Variant = what.rest[1] if what.rest[1] is String else ""
		_check(count == what.rest[0], "{0} expected to emit {1} {2} times, not {3}", values, note)


func assert_signal_emitted_with_parameters(
	p1: Variant, p2: Variant, p3: Variant = -1, p4: Variant = -1
) -> void:
	var what: Call = Call.new([p1, p2, p3, p4])
	if not _is_watched(what):
		return
	var index: int = what.rest[1] if what.rest.size() > 1 and what.rest[1] is int else -1
	var got: Variant = _emission(what, index)
	var holds: bool = got != null and _deep_equal(got, what.rest[0])
	var values: Array = [what.object, what.signal_name, what.rest[0], got]
	_check(holds, "{0} expected to emit {1} with {2}, not {3}", values, "")


## (object, connected object, "signal", "method"), or (object.signal, connected object or method).
func assert_connected(p1: Variant, p2: Variant, p3: Variant = null, p4: Variant = "") -> void:
	var place: String = "{0} expected to be connected to {1}: {2} {3}"
	_check(_is_connected(p1, p2, p3, p4), place, [p1, p2, p3, p4], "")


func assert_not_connected(p1: Variant, p2: Variant, p3: Variant = null, p4: Variant = "") -> void:
	var place: String = "{0} expected not to be connected to {1}: {2} {3}"
	_check(not _is_connected(p1, p2, p3, p4), place, [p1, p2, p3, p4], "")


func end_call() -> void:
	_watcher.clear()
	super()


func _is_connected(p1: Variant, p2: Variant, p3: Variant, p4: Variant) -> bool:
	var signaler: Object = p1.get_object() if p1 is Signal else p1
	var signal_name: StringName = p1.get_name() if p1 is Signal else StringName(str(p3))
	if not signaler.has_signal(signal_name):
		return false
	for connection: Dictionary in signaler.get_signal_connection_list(signal_name):
		var callable: Callable = connection["callable"]
		if p2 is Callable:
			if callable == p2:
				return true
		elif callable.get_object() == p2:
			if p1 is Signal or str(p4).is_empty() or callable.get_method() == StringName(str(p4)):
				return true
	return false


func _is_watched(what: Call) -> bool:
	if what.object == null or not what.object.has_signal(what.signal_name):
		_check(false, "{0} has no signal {1}", [what.object, what.signal_name], "")
		return false
	if not _watcher.is_watching(what.object):
		_check(false, "{0} is not watched: call watch_signals() with it", [what.object], "")
		return false
	return true


func _emission(what: Call, index: int) -> Variant:
	var emissions: Array = _watcher.emissions(what.object, what.signal_name)
	var at: int = emissions.size() - 1 if index < 0 else index
	return emissions[at] if at >= 0 and at < emissions.size() else null
