# SPDX-License-Identifier: MIT
class_name InputBindings
extends RefCounted
## Which keys and buttons the actions have: the project's, and a user's changes to them.

enum Device { KEYBOARD, MOUSE, GAMEPAD }

# What the project gives, read once.
static var _given: Dictionary[StringName, PackedStringArray] = {}

## Of each changed action all that it has, as BindingText.
var _changes: Dictionary[StringName, PackedStringArray] = {}


## The changes in data of a file; `faults` gets a sentence for each thing that is wrong.
static func from_json(data: Dictionary, faults: Array[String]) -> InputBindings:
	var bindings := InputBindings.new()
	for name: Variant in data:
		var action := StringName(str(name))
		if not ActionList.actions().has(action):
			faults.append(_translated("No action '%s' can be bound. Remove it.") % action)
		elif not data[name] is Array:
			faults.append(_translated("The bindings of '%s' must be a list.") % action)
		else:
			var listed: Array = data[name]
			var words := PackedStringArray()
			for entry: Variant in listed:
				if entry is String and BindingText.to_event(str(entry)) != null:
					words.append(str(entry))
				else:
					faults.append(
						(
							_translated("There is no key or button '%s' for '%s'.")
							% [JsonWords.names([entry]), action]
						)
					)
			if words.size() == listed.size():
				bindings._set_words(action, words)
	return bindings


## The changes alone, for a file.
func to_json() -> Dictionary:
	var data: Dictionary[String, Array] = {}
	for action in _changes:
		data[String(action)] = Array(_changes[action])
	var plain: Dictionary = {}
	plain.assign(data)
	return plain


## What the project gives an action.
static func given(action: StringName) -> PackedStringArray:
	if _given.has(action):
		return _given[action]
	var words := PackedStringArray()
	var entry: Dictionary = ProjectSettings.get_setting("input/" + action, {})
	var events: Array = entry.get("events", [])
	for event: InputEvent in events:
		words.append(BindingText.of(event))
	_given[action] = words
	return words


## All that an action has.
func words_of(action: StringName) -> PackedStringArray:
	return _changes[action] if _changes.has(action) else given(action)


## What an action has of one device.
func events_of(action: StringName, device: Device) -> Array[InputEvent]:
	var events: Array[InputEvent] = []
	for words in words_of(action):
		if device_of(words) == device:
			events.append(BindingText.to_event(words))
	return events


## Gives an action this event alone of its device. False when it cannot be: the action is fixed, or
## the event is that of a fixed one or nothing to bind.
func bind(action: StringName, event: InputEvent) -> bool:
	var words := BindingText.of(event)
	if words.is_empty() or not ActionList.actions().has(action) or is_reserved(words):
		return false
	_set_words(action, _without(action, device_of(words)) + PackedStringArray([words]))
	return true


## Takes all of a device from an action.
func clear(action: StringName, device: Device) -> void:
	if ActionList.actions().has(action):
		_set_words(action, _without(action, device))


## Gives an action back what the project gives it.
func reset(action: StringName) -> void:
	_changes.erase(action)


func reset_all() -> void:
	_changes.clear()


func is_changed(action: StringName) -> bool:
	return _changes.has(action)


## The actions that one press of these words could mean besides this one.
func rivals(action: StringName, words: String) -> Array[StringName]:
	var found: Array[StringName] = []
	for other in ActionList.actions():
		if other != action and ActionList.meet(action, other) and words_of(other).has(words):
			found.append(other)
	return found


## Whether this opens the menu, whatever else is bound.
static func is_reserved(words: String) -> bool:
	for action in ActionList.FIXED:
		if given(action).has(words):
			return true
	return false


## Puts everything into the input map. Actions of the menus keep what they have.
func apply() -> void:
	for action in ActionList.actions():
		InputMap.action_erase_events(action)
		for words in words_of(action):
			InputMap.action_add_event(action, BindingText.to_event(words))


static func device_of(words: String) -> Device:
	match words.get_slice(":", 0):
		BindingText.MOUSE:
			return Device.MOUSE
		BindingText.PAD, BindingText.AXIS:
			return Device.GAMEPAD
	return Device.KEYBOARD


func _without(action: StringName, device: Device) -> PackedStringArray:
	var kept := PackedStringArray()
	for words in words_of(action):
		if device_of(words) != device:
			kept.append(words)
	return kept


func _set_words(action: StringName, words: PackedStringArray) -> void:
	if words == given(action):
		_changes.erase(action)
	else:
		_changes[action] = words


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
