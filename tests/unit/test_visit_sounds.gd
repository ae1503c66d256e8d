# SPDX-License-Identifier: MIT
extends GutTest
## The sounds of a visit are short, quiet and without clicks.

const LOUDEST: float = 0.3
const LONGEST: float = 0.5
## A step between two samples above this is heard as a click.
const STEEPEST: float = 0.06


func test_each_is_short_quiet_and_ends_at_nothing(
	sound: StringName = use_parameters(VisitSounds.NAMES)
) -> void:
	var samples := VisitSounds.samples_of(sound)
	assert_gt(samples.size(), 500, "there is something")
	assert_lt(float(samples.size()) / ToneMaker.RATE, LONGEST)
	var peak := 0.0
	var mean := 0.0
	var step := 0.0
	var last := 0.0
	for sample in samples:
		peak = maxf(peak, absf(sample))
		mean += sample / samples.size()
		step = maxf(step, absf(sample - last))
		last = sample
	assert_between(peak, 0.05, LOUDEST, "peak")
	assert_almost_eq(mean, 0.0, 1e-6, "mean")
	assert_almost_eq(samples[0], 0.0, 1e-6, "begins at nothing")
	assert_almost_eq(samples[-1], 0.0, 1e-6, "ends at nothing")
	assert_lt(step, STEEPEST, "no step")


func test_hovering_is_the_softest() -> void:
	for sound in VisitSounds.NAMES:
		if sound != VisitSounds.HOVER:
			assert_gt(_power(sound), 2.0 * _power(VisitSounds.HOVER), sound)


func test_the_blink_is_a_low_breath() -> void:
	var samples := VisitSounds.samples_of(VisitSounds.BLINK)
	var crossings := 0
	for i in range(1, samples.size()):
		crossings += 1 if samples[i] * samples[i - 1] < 0.0 else 0
	var hertz := 0.5 * crossings * ToneMaker.RATE / samples.size()
	assert_between(hertz, 100.0, 900.0)


func test_streams_hold_the_samples() -> void:
	var samples := VisitSounds.samples_of(VisitSounds.CHOOSE)
	var stream := ToneMaker.to_stream(samples)
	assert_eq(stream.data.size(), 2 * samples.size())
	assert_almost_eq(stream.get_length(), float(samples.size()) / ToneMaker.RATE, 1e-4)
	assert_almost_eq(stream.data.decode_s16(2000) / 32767.0, samples[1000], 1e-4)


func test_plays_unless_muted() -> void:
	var sounds: VisitSounds = add_child_autofree(VisitSounds.new())
	sounds.volume_db = -60.0
	sounds.play(VisitSounds.WARNING)
	assert_true(sounds.is_playing(VisitSounds.WARNING))
	sounds.muted = true
	assert_false(sounds.is_playing(VisitSounds.WARNING), "muting ends what sounds")
	sounds.play(VisitSounds.CARD)
	assert_false(sounds.is_playing(VisitSounds.CARD))
	for player: AudioStreamPlayer in sounds.get_children():
		assert_eq(player.volume_db, -60.0)


func test_an_unknown_name_is_said() -> void:
	var sounds: VisitSounds = add_child_autofree(VisitSounds.new())
	sounds.play(&"bang")
	assert_push_error("bang")


func _power(sound: StringName) -> float:
	var sum := 0.0
	for sample in VisitSounds.samples_of(sound):
		sum += sample * sample
	return sum
