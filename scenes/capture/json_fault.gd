# SPDX-License-Identifier: MIT
class_name JsonFault
extends RefCounted
## One thing that a schema forbids in some data.

enum Kind {
	## The value itself: its type, its range, which of the allowed ones it is.
	VALUE,
	## A key that must be there and is not.
	MISSING,
	## A key that nobody knows.
	UNKNOWN,
	## A rule about several values.
	RULE,
}

var kind: Kind
## Where: keys joined by dots, list places in brackets; empty for the whole.
var place: String
## What is wrong and what is allowed: a sentence.
var text: String


func _init(fault_kind: Kind, where: String, sentence: String) -> void:
	kind = fault_kind
	place = where
	text = sentence
