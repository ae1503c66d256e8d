# SPDX-License-Identifier: MIT
class_name VisitSounds
extends Node
## The quiet sounds of a visit: that something is pointed at, chosen, opened; a blink; a warning.
## They are made when the scene starts; nothing is computed while they play.

const HOVER: StringName = &"hover"
const CHOOSE: StringName = &"choose"
const BLINK: StringName = &"blink"
const CARD: StringName = &"card"
const WARNING: StringName = &"warning"
## Names of all sounds.
const NAMES: Array[StringName] = [HOVER, CHOOSE, BLINK, CARD, WARNING]
## So many of one kind may sound at a time.
const VOICES: int = 2

## Loudness of all sounds.
@export_range(-60.0, 0.0, 0.5, "suffix:dB") var volume_db: float = -18.0:
	set(value):
		volume_db = value
		for player: AudioStreamPlayer in _players.values():
			player.volume_db = volume_db
@export var muted: bool = false:
	set(value):
		muted = value
		if muted:
			for player: AudioStreamPlayer in _players.values():
				player.stop()
## The audio bus that they are sent to.
@export var bus: StringName = &"Master"

var _players: Dictionary[StringName, AudioStreamPlayer] = {}


func _ready() -> void:
	for sound in NAMES:
		var player := AudioStreamPlayer.new()
		player.stream = ToneMaker.to_stream(samples_of(sound))
		player.volume_db = volume_db
		player.bus = bus
		player.max_polyphony = VOICES
		_players[sound] = player
		add_child(player)


## Plays one of NAMES; nothing while muted.
func play(sound: StringName) -> void:
	if not _players.has(sound):
		push_error("VisitSounds: there is no sound '%s'." % sound)
	elif not muted:
		_players[sound].play()


## Does one of NAMES sound now?
func is_playing(sound: StringName) -> bool:
	return _players.has(sound) and _players[sound].playing


## The samples of one of NAMES, -1 to 1, ToneMaker.RATE a second.
static func samples_of(sound: StringName) -> PackedFloat32Array:
	match sound:
		HOVER:
			var tick := ToneMaker.silence(0.05)
			ToneMaker.add_tone(tick, 1320.0, 0.0, 0.05, 1.0, 0.004)
			return ToneMaker.finished(tick, 0.08)
		CHOOSE:
			var notes := ToneMaker.silence(0.34)
			ToneMaker.add_tone(notes, 523.25, 0.0, 0.2)
			ToneMaker.add_tone(notes, 783.99, 0.1, 0.24)
			return ToneMaker.finished(notes, 0.2)
		BLINK:
			var breath := ToneMaker.silence(0.26)
			ToneMaker.add_breath(breath, 420.0, 1)
			return ToneMaker.finished(breath, 0.16)
		CARD:
			var chord := ToneMaker.silence(0.4)
			ToneMaker.add_tone(chord, 392.0, 0.0, 0.4, 0.7, 0.03)
			ToneMaker.add_tone(chord, 587.33, 0.04, 0.36, 0.5, 0.03)
			return ToneMaker.finished(chord, 0.17)
		WARNING:
			var low := ToneMaker.silence(0.46)
			ToneMaker.add_tone(low, 196.0, 0.0, 0.22, 1.0, 0.03)
			ToneMaker.add_tone(low, 174.61, 0.2, 0.26, 1.0, 0.03)
			return ToneMaker.finished(low, 0.26)
	return []
