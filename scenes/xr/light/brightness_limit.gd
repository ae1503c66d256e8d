# SPDX-License-Identifier: MIT
class_name BrightnessLimit
extends Node
## Keeps the sky from blinding: where the observer's motion and depth make a good part of it
## brighter than `allowed_ev` over the sky far away, the exposure is taken back, gently.
##
## A direction's gain is g^4, the frequency ratio's power by which the light of a piece of sky grows
## (surface brightness over frequency cubed is the same for all observers). A thin bright ring round
## the shadow may be brighter: it would leave everything else black.

const DIRECTIONS: int = 48
const DIRECTIONS_PER_FRAME: int = 6
## This part of the sky that is seen may be brighter.
const BRIGHTER: float = 0.2
## Seconds in which 63 % of a change is made.
const SETTLING: float = 0.8

@export var sky: BlackHoleSky
@export var head: Node3D
## So much brighter than far away may it become, EV.
@export_range(0.0, 4.0, 0.1, "suffix:EV") var allowed_ev: float = 0.7

var _directions: PackedVector3Array = []
var _gains: PackedFloat64Array = []
var _next: int = 0
var _excess: float = 0.0
var _taken: float = 0.0
var _static := SkyObserver.new()


func _init() -> void:
	_static.motion = LensingTable.MOTION_STATIC
	for i in DIRECTIONS:
		var z := 1.0 - (2.0 * i + 1.0) / DIRECTIONS
		var azimuth := i * PI * (3.0 - sqrt(5.0))
		var across := sqrt(1.0 - z * z)
		_directions.append(Vector3(across * cos(azimuth), across * sin(azimuth), z))
	_gains.resize(DIRECTIONS)
	_gains.fill(1.0)


func _process(delta: float) -> void:
	for i in DIRECTIONS_PER_FRAME:
		_look(_next)
		_next = (_next + 1) % DIRECTIONS
	if _next == 0:
		_sum_up()
	_follow(_excess, delta)


func _exit_tree() -> void:
	_follow(0.0, INF)


## How much too bright the sky is by itself, EV; 0: it is not.
func excess_ev() -> float:
	return _excess


## How much is taken from the exposure now, EV.
func get_taken_ev() -> float:
	return _taken


## Takes what is to be taken at once: after a jump that nobody sees.
func adapt_at_once() -> void:
	look_round()
	_follow(_excess, INF)


## Looks into all directions at once.
func look_round() -> void:
	for i in DIRECTIONS:
		_look(i)
	_sum_up()


func _look(which: int) -> void:
	var observer := sky.observer if sky.observer != null else _static
	var place := (head.global_position - sky.global_position) / sky.schwarzschild_radius
	if sky.lensing < 0.999 or not observer.get_refusal(place).is_empty():
		_gains[which] = 1.0
		return
	var ray := observer.trace(place, _directions[which])
	var seen: bool = not ray.is_empty() and not ray["captured"]
	_gains[which] = pow(ray["redshift"], 4.0) if seen else 0.0


func _sum_up() -> void:
	var sorted := _gains.duplicate()
	sorted.sort()
	var shadow := sorted.count(0.0)
	var bright := sorted[DIRECTIONS - 1 - floori(BRIGHTER * (DIRECTIONS - shadow))]
	_excess = maxf(log(maxf(bright, 1e-9)) / log(2.0) - allowed_ev, 0.0)


# Others may set the exposure too: only what was taken changes.
func _follow(wanted: float, seconds: float) -> void:
	var kept := exp(-seconds / SETTLING)
	var next := wanted + (_taken - wanted) * kept
	if absf(next - wanted) < 0.005:
		next = wanted
	if next != _taken and sky != null:
		sky.exposure += _taken - next
		_taken = next
