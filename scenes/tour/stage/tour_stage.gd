# SPDX-License-Identifier: MIT
class_name TourStage
extends Node
## What a tour is shown on: a screen or a headset. The guide calls these in the order below; each
## stage overrides them all.


## A tour begins: what the stage changes is to be as before after leave().
func begin() -> void:
	pass


## The way to a station begins.
func arrive(_station: TourStation) -> void:
	pass


## Whether the way is done.
func is_arrived() -> bool:
	return true


## A caption of the station is on, the first is 0; `by_hand`: a ride is to be where it belongs.
func show_caption(_index: int, _by_hand: bool) -> void:
	pass


## What a caption says here, in English.
func words_of(caption: TourCaption) -> String:
	return caption.text


## Whether the picture has come to where a later caption belongs.
func is_ready_for(_caption: TourCaption) -> bool:
	return true


func set_paused(_paused: bool) -> void:
	pass


## Lets `seconds` pass.
func advance(_seconds: float) -> void:
	pass


## The tour is over.
func leave() -> void:
	pass
