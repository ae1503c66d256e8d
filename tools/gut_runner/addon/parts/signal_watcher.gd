# SPDX-License-Identifier: MIT
extends RefCounted
## Records every emission of every signal of the objects it watches.

## Instance id -> signal name -> array of argument arrays, one per emission.
var _emissions: Dictionary[int, Dictionary] = {}
## Instance id -> array of [signal name, callable], to disconnect.
var _connections: Dictionary[int, Array] = {}


## Starts recording all signals of an object; a second call changes nothing.
func watch(object: Object) -> void:
	var id: int = object.get_instance_id()
	if _emissions.has(id):
		return
	_emissions[id] = {}
	_connections[id] = []
	for info: Dictionary in object.get_signal_list():
		var signal_name: StringName = info["name"]
		var log_of_signal: Array = []
		_emissions[id][signal_name] = log_of_signal
		var record: Callable = func(...args: Array) -> void: log_of_signal.append(args)
		object.connect(signal_name, record)
		_connections[id].append([signal_name, record])


func is_watching(object: Object) -> bool:
	return _emissions.has(object.get_instance_id())


## The argument arrays of all emissions of one signal; empty when it was never emitted or not
## watched.
func emissions(object: Object, signal_name: StringName) -> Array:
	var of_object: Dictionary = _emissions.get(object.get_instance_id(), {})
	return of_object.get(signal_name, [])


## The names of the signals of an object that were emitted.
func emitted_names(object: Object) -> PackedStringArray:
	var names: PackedStringArray = []
	var of_object: Dictionary = _emissions.get(object.get_instance_id(), {})
	for signal_name: StringName in of_object:
		var log_of_signal: Array = of_object[signal_name]
		if not log_of_signal.is_empty():
			names.append(signal_name)
	return names


## Stops watching and forgets everything.
func clear() -> void:
	for id: int in _connections:
		var object: Object = instance_from_id(id)
		if object == null:
			continue
		for connection: Array in _connections[id]:
			if object.is_connected(connection[0], connection[1]):
				object.disconnect(connection[0], connection[1])
	_connections.clear()
	_emissions.clear()
