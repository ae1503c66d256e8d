# SPDX-License-Identifier: MIT
class_name MenuItem
extends RefCounted
## One line of a menu: what it says, what it does, what it shows at the right.

enum Kind {
	## Does something at once. With a value that is true it bears a mark.
	ACTION,
	## Is on or off.
	TOGGLE,
	## Goes on to the next of a few things and shows the present one by name.
	CHOICE,
	## Leads to another page.
	PAGE,
}

var id: StringName
var kind := Kind.ACTION
## As written in the source; it is translated when shown.
var text: String
## Which page a PAGE leads to.
var page: StringName
## A page that is to be found by who cannot read the present language.
var bears_globe: bool = false
## The menu closes afterwards, so that one sees what has begun.
var closes: bool = false

var _act: Callable
var _value: Callable
var _refusal: Callable


## `does` is called without arguments when the item is chosen.
static func action(item_id: StringName, words: String, does: Callable) -> MenuItem:
	return _make(item_id, words, Kind.ACTION, does)


## `is_on` returns a bool.
static func toggle(item_id: StringName, words: String, is_on: Callable, does: Callable) -> MenuItem:
	return _make(item_id, words, Kind.TOGGLE, does).showing(is_on)


## `present` returns the present choice's name, translated.
static func choice(
	item_id: StringName, words: String, present: Callable, does: Callable
) -> MenuItem:
	return _make(item_id, words, Kind.CHOICE, does).showing(present)


static func to_page(words: String, leads_to: StringName) -> MenuItem:
	var made := _make(leads_to, words, Kind.PAGE, Callable())
	made.page = leads_to
	return made


## What is shown at the right.
func showing(value: Callable) -> MenuItem:
	_value = value
	return self


## `refusal` returns why the item cannot be chosen now, translated; empty when it can.
func refused_by(refusal: Callable) -> MenuItem:
	_refusal = refusal
	return self


func with_globe() -> MenuItem:
	bears_globe = true
	return self


func closing() -> MenuItem:
	closes = true
	return self


## A bool for a toggle, a String for a choice; null: there is nothing to show.
func get_value() -> Variant:
	return _value.call() if _value.is_valid() else null


## Why it cannot be chosen now; empty: it can.
func get_refusal() -> String:
	var refusal: String = _refusal.call() if _refusal.is_valid() else ""
	return refusal


## Does what it is there for.
func act() -> void:
	if _act.is_valid():
		_act.call()


static func _make(item_id: StringName, words: String, of: Kind, does: Callable) -> MenuItem:
	var item := MenuItem.new()
	item.id = item_id
	item.text = words
	item.kind = of
	item._act = does
	return item
