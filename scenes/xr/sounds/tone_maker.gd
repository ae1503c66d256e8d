# SPDX-License-Identifier: MIT
class_name ToneMaker
extends RefCounted
## Makes short sounds out of numbers: tones and breaths of noise that begin and end at nothing.

const RATE: int = 22050


## Silence of so many seconds, to add tones to.
static func silence(seconds: float) -> PackedFloat32Array:
	var samples: PackedFloat32Array = []
	samples.resize(roundi(seconds * RATE))
	return samples


## Adds a tone of `hertz` that begins at `start` and lasts `length`, both in seconds. Its loudness
## rises within `attack` seconds and dies away from there.
static func add_tone(
	samples: PackedFloat32Array,
	hertz: float,
	start: float,
	length: float,
	strength: float = 1.0,
	attack: float = 0.012
) -> void:
	var first := roundi(start * RATE)
	for i in mini(roundi(length * RATE), samples.size() - first):
		var t := float(i) / RATE
		samples[first + i] += strength * _swell(t, attack, length) * sin(TAU * hertz * t)


## Adds noise without what is above `hertz`, swelling and fading over the whole length. The same
## `number` makes the same noise.
static func add_breath(samples: PackedFloat32Array, hertz: float, number: int) -> void:
	var random := RandomNumberGenerator.new()
	random.seed = number
	var weight := 1.0 - exp(-TAU * hertz / RATE)
	var once := 0.0
	var twice := 0.0
	for i in samples.size():
		once += weight * (random.randf_range(-1.0, 1.0) - once)
		twice += weight * (once - twice)
		samples[i] += _bell(i, samples.size()) * twice


## The sound with its mean taken away, faded at both ends and as loud as `peak`, 0 to 1.
static func finished(samples: PackedFloat32Array, peak: float) -> PackedFloat32Array:
	var done := samples.duplicate()
	var sum := 0.0
	var weights := 0.0
	for i in done.size():
		done[i] *= _edge(i, done.size())
		sum += done[i]
		weights += _bell(i, done.size())
	var largest := 0.0
	for i in done.size():
		done[i] -= sum / weights * _bell(i, done.size())
		largest = maxf(largest, absf(done[i]))
	for i in done.size():
		done[i] *= peak / maxf(largest, 1e-9)
	return done


## The same as the engine plays it.
static func to_stream(samples: PackedFloat32Array) -> AudioStreamWAV:
	var bytes: PackedByteArray = []
	bytes.resize(2 * samples.size())
	for i in samples.size():
		bytes.encode_s16(2 * i, roundi(clampf(samples[i], -1.0, 1.0) * 32767.0))
	var stream := AudioStreamWAV.new()
	stream.format = AudioStreamWAV.FORMAT_16_BITS
	stream.mix_rate = RATE
	stream.data = bytes
	return stream


# Up within `attack`, then down to nothing at the end.
static func _swell(t: float, attack: float, length: float) -> float:
	if t < attack:
		return sin(0.5 * PI * t / attack) ** 2
	return cos(0.5 * PI * (t - attack) / (length - attack)) ** 4


static func _bell(i: int, count: int) -> float:
	return sin(PI * i / maxf(count - 1, 1.0)) ** 2


# 1 but for 3 ms at both ends.
static func _edge(i: int, count: int) -> float:
	var reach := 0.003 * RATE
	return smoothstep(0.0, 1.0, minf(i, count - 1 - i) / reach)
