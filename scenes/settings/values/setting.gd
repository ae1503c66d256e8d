# SPDX-License-Identifier: MIT
class_name Setting
extends RefCounted
## One thing that a user can set: which values it takes, which it has at first, and its name on the
## screen.

enum Kind { SWITCH, NUMBER, CHOICE, BINDINGS }

var key: StringName
var kind: Kind
## Name and, where the name does not say it all, what it does. In English: keys of translations.
var title: String
var note: String = ""
## The value without anybody's wish: that of the scenes.
var initial: Variant
## Of a number.
var least: float
var most: float
var step: float
## How the number is written, with one place for it.
var format: String = "%d"
## Of a choice: values as they are in the file, and their names.
var choices := PackedStringArray()
var titles := PackedStringArray()


static func on_off(name: StringName, words: String, on: bool, about: String = "") -> Setting:
	var setting := _make(name, Kind.SWITCH, words, on, about)
	setting.titles = ["Off", "On"]
	return setting


## `limits` are the least value, the most and the step.
static func number(
	name: StringName, words: String, at: float, limits: Vector3, written: String, about: String = ""
) -> Setting:
	var setting := _make(name, Kind.NUMBER, words, at, about)
	setting.least = limits.x
	setting.most = limits.y
	setting.step = limits.z
	setting.format = written
	return setting


## `named` gives each value its name.
static func choice(
	name: StringName,
	words: String,
	chosen: String,
	named: Dictionary[String, String],
	about: String = ""
) -> Setting:
	var setting := _make(name, Kind.CHOICE, words, chosen, about)
	setting.choices = named.keys()
	setting.titles = named.values()
	return setting


## What each action is bound to, where that is not as in the project.
static func bindings(name: StringName) -> Setting:
	return _make(name, Kind.BINDINGS, "", {}, "")


## Whether it can have this value.
func takes(value: Variant) -> bool:
	match kind:
		Kind.SWITCH:
			return value is bool
		Kind.NUMBER:
			if not (value is float or value is int):
				return false
			var number_value: float = value
			return number_value >= least and number_value <= most
		Kind.CHOICE:
			return value is String and choices.has(value)
	return value is Dictionary


## Which values it takes, for whoever edits the file.
func rule() -> String:
	match kind:
		Kind.SWITCH:
			return "true, false"
		Kind.NUMBER:
			return "%s … %s" % [String.num(least), String.num(most)]
		Kind.CHOICE:
			return ", ".join(choices)
	return '{"action": ["key:F"]}'


## The place of a value among the names, for switches and choices.
func place_of(value: Variant) -> int:
	if kind == Kind.SWITCH:
		return 1 if value == true else 0
	var name: String = value
	return choices.find(name)


## The value at a place among the names, for switches and choices.
func value_at(place: int) -> Variant:
	if kind == Kind.SWITCH:
		return place == 1
	return choices[place]


static func _make(
	name: StringName, of_kind: Kind, words: String, at: Variant, about: String
) -> Setting:
	var setting := Setting.new()
	setting.key = name
	setting.kind = of_kind
	setting.title = words
	setting.initial = at
	setting.note = about
	return setting
