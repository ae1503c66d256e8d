# SPDX-License-Identifier: MIT
class_name SoundOutput
extends RefCounted
## How loud everything is that is heard, and whether both ears hear the same.

const BUS: int = 0
## Quieter than this nothing is heard, in dB.
const SILENCE: float = -80.0
const MONO: String = "Mono"


## `percent` is the loudness as the slider has it: half of it is about half as loud to the ear.
static func set_volume(percent: float) -> void:
	# Loudness doubles every 10 dB.
	var loudness := 10.0 * log(maxf(percent, 1e-3) / 100.0) / log(2.0)
	AudioServer.set_bus_volume_db(BUS, maxf(loudness, SILENCE) if percent > 0.0 else SILENCE)


static func set_mute(muted: bool) -> void:
	AudioServer.set_bus_mute(BUS, muted)


static func set_mono(wanted: bool) -> void:
	for at in range(AudioServer.get_bus_effect_count(BUS) - 1, -1, -1):
		if AudioServer.get_bus_effect(BUS, at).resource_name == MONO:
			AudioServer.remove_bus_effect(BUS, at)
	if wanted:
		# Without width both sides are the mean of the two.
		var narrow := AudioEffectStereoEnhance.new()
		narrow.resource_name = MONO
		narrow.pan_pullout = 0.0
		AudioServer.add_bus_effect(BUS, narrow)
