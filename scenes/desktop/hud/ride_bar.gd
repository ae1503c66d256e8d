# SPDX-License-Identifier: MIT
class_name RideBar
extends PanelContainer
## What a ride shows and lets be done: its clocks, its pace, its way.

## Seconds between two updates: numbers that flicker cannot be read.
const INTERVAL: float = 0.1

@export var sky: BlackHoleSky
@export var director: RideDirector

var _elapsed: float = INTERVAL

@onready var _title: Label = %Title
@onready var _pace: Label = %Pace
@onready var _own: Label = %Own
@onready var _own_seconds: Label = %OwnSeconds
@onready var _rain: Label = %Rain
@onready var _rain_caption: Label = %RainCaption
@onready var _rain_seconds: Label = %RainSeconds
@onready var _far: Label = %Far
@onready var _far_where: Label = %FarWhere
@onready var _thrust: Label = %Thrust
@onready var _thrust_natural: Label = %ThrustNatural
@onready var _track: RideTrack = %Track
@onready var _buttons: Dictionary[StringName, Button] = {
	&"ride_pause": %Pause,
	&"ride_reverse": %Reverse,
	&"ride_slower": %Slower,
	&"ride_faster": %Faster,
	&"ride_leave": %Leave,
}


func _ready() -> void:
	_buttons[&"ride_pause"].pressed.connect(director.toggle_pause)
	_buttons[&"ride_reverse"].pressed.connect(director.reverse)
	_buttons[&"ride_slower"].pressed.connect(director.change_pace.bind(-1))
	_buttons[&"ride_faster"].pressed.connect(director.change_pace.bind(1))
	_buttons[&"ride_leave"].pressed.connect(director.leave)
	_track.value_changed.connect(director.seek)
	director.started.connect(update)
	director.left.connect(hide)


func _process(delta: float) -> void:
	_elapsed += delta
	if _elapsed >= INTERVAL and director.is_on():
		_elapsed = 0.0
		update()


func update() -> void:
	var ride := director.ride
	show()
	_title.text = ride.get_title()
	_pace.text = _pace_text(ride)
	_show_clocks(ride)
	_show_thrust(ride)
	_track.visible = ride.is_reversible()
	_track.set_value_no_signal(ride.get_progress())
	_track.mark = (ride as FallRide).progress_of(1.0) if ride is FallRide else -1.0
	_name_buttons(ride)


func _pace_text(ride: Ride) -> String:
	var pace := director.pace
	if not ride.has_hole():
		return tr("speed held") if pace.paused else ""
	var rate := pace.rate(ride.get_place().length()) * sky.get_time_unit_seconds()
	var text := tr("1 s shows %s, pace %s") % [ReadoutText.duration(rate), pace.get_factor_text()]
	if pace.paused:
		return "%s  ·  %s" % [text, tr("paused")]
	return "%s  ·  %s" % [text, tr("backwards")] if pace.reversed else text


func _show_clocks(ride: Ride) -> void:
	var own := ride.get_proper_time()
	var rain := ride.get_rain_time()
	_far.text = ReadoutText.clock_rate(ride.get_far_clock_rate())
	if ride.has_hole():
		var unit := sky.get_time_unit_seconds()
		_own.text = ReadoutText.natural_time(own)
		_own_seconds.text = ReadoutText.duration(own * unit)
		_rain_caption.text = tr("Rain clock")
		_rain.text = ReadoutText.natural_time(rain)
		_rain_seconds.text = ReadoutText.duration(rain * unit)
		_far_where.text = tr("away from the hole")
	else:
		_own.text = ReadoutText.duration(own)
		_own_seconds.text = ""
		_rain_caption.text = tr("Stars' clock")
		_rain.text = ReadoutText.duration(rain)
		_rain_seconds.text = ""
		_far_where.text = tr("in the picture's middle")


func _show_thrust(ride: Ride) -> void:
	var thrust := ride.get_thrust().length()
	_thrust.text = ReadoutText.acceleration(thrust, sky.get_acceleration_unit_g())
	_thrust_natural.text = tr("free fall") if thrust == 0.0 else _natural_thrust(thrust)
	if not ride.has_hole():
		_thrust.text = ReadoutText.NOTHING
		_thrust_natural.text = ""


func _natural_thrust(thrust: float) -> String:
	return "%s c²/rₛ" % ReadoutText.significant(thrust)


func _name_buttons(ride: Ride) -> void:
	var names: Dictionary[StringName, String] = {
		&"ride_pause": tr("Go on") if director.pace.paused else tr("Pause"),
		&"ride_reverse": tr("Forwards") if director.pace.reversed else tr("Backwards"),
		&"ride_slower": tr("Slower"),
		&"ride_faster": tr("Faster"),
		&"ride_leave": tr("Leave"),
	}
	if not ride.has_hole():
		names[&"ride_pause"] = tr("Let go") if director.pace.paused else tr("Hold speed")
	for action in names:
		_buttons[action].text = "%s  [%s]" % [names[action], BindingNames.keyboard([action])]
	_buttons[&"ride_reverse"].visible = ride.is_reversible()
