# SPDX-License-Identifier: MIT
extends Node3D
## A fall from rest through the horizon, played by an AnimationPlayer: exact at every moment, and
## with the player's own pause, speed and seek.

const START_RADIUS: float = 10.0
const END_RADIUS: float = 0.1
const SECONDS: float = 24.0
const KEYS: int = 240

@onready var _sky: BlackHoleSky = $Sky
@onready var _player: AnimationPlayer = $Player


func _ready() -> void:
	var fall := RadialFallPath.new()
	if fall.start_from_rest(START_RADIUS) != OK:
		push_error(fall.get_error_message())
		return
	_sky.observer = SkyObserver.new()
	_sky.observer.motion = LensingTable.MOTION_INFALL
	# A hair more, so that rounding does not put the start above its turning point.
	_sky.observer.energy = sqrt(fall.get_energy() ** 2 + 2e-7)
	var animation := Animation.new()
	animation.length = SECONDS
	animation.loop_mode = Animation.LOOP_LINEAR
	var track := animation.add_track(Animation.TYPE_POSITION_3D)
	animation.track_set_path(track, ^"Camera")
	var whole := fall.proper_time_to(END_RADIUS)
	for key in KEYS + 1:
		var share := float(key) / KEYS
		animation.position_track_insert_key(
			track, share * SECONDS, fall.position_at(share * whole, Vector3.BACK)
		)
	var library := AnimationLibrary.new()
	library.add_animation(&"fall", animation)
	_player.add_animation_library(&"", library)
	_player.play(&"fall")
