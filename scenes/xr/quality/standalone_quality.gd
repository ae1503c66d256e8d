# SPDX-License-Identifier: MIT
class_name StandaloneQuality
extends RefCounted
## What a headset without a computer can draw: the picture to begin with, and the rungs below it.
## Such devices use the Compatibility renderer and the headset's own foveation.

const RENDERER: String = "gl_compatibility"
## The outer parts of the picture are drawn coarsely.
const FOVEATED: bool = true


## Is this program running on such a device?
static func is_here() -> bool:
	return OS.has_feature("mobile") or OS.has_feature("web_android")


## The picture to begin with.
static func top() -> QualityRung:
	return QualityRung.make(2, 6.5, true, 2, 1.0)


## What follows when that is too much, from dear to cheap.
static func rungs() -> Array[QualityRung]:
	return [
		QualityRung.make(2, 6.0, true, 1, 0.85),
		QualityRung.make(1, 5.5, true, 1, 0.75),
		QualityRung.make(1, 5.0, true, 1, 0.6),
	]


## Sets everything; to be called before the session starts and the ladder is ready. Nobody but the
## visitor looks on there: the spectators' view, if any, is switched off.
static func apply(ladder: QualityLadder, session: XrSession, spectator: Spectator = null) -> void:
	var choice := PictureChoice.new()
	choice.sky = ladder.sky
	choice.disk = ladder.disk
	choice.note()
	choice.apply(top())
	ladder.rungs = rungs()
	if session != null:
		session.foveated = FOVEATED
	if spectator != null:
		spectator.mode = Spectator.Mode.OFF
