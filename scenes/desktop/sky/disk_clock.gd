# SPDX-License-Identifier: MIT
class_name DiskClock
extends Node
## Lets the disk's time pass: on a ride round or into the hole by the ride's rain clock, to and fro
## as the ride goes, else evenly.

@export var disk: AccretionDisk
@export var director: RideDirector

## Time, in light travel times of a Schwarzschild radius, in a second without a ride; 0 stops it.
var rate: float = 10.0

var _ride: Ride
## The disk's time when the ride's clock was at 0.
var _start: float = 0.0


func _process(_delta: float) -> void:
	follow()


## Whether a ride sets the time.
func is_on_ride() -> bool:
	return director.is_on() and director.ride.has_hole()


## Takes over the present ride's time, or the rate.
func follow() -> void:
	var ride := director.ride if is_on_ride() else null
	disk.time_scale = rate if ride == null else 0.0
	if ride != null:
		if ride != _ride:
			_start = disk.time - ride.get_rain_time()
		disk.time = _start + ride.get_rain_time()
	_ride = ride
