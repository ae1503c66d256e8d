# SPDX-License-Identifier: MIT
class_name RingJump
extends PointTarget
## Rings of fixed r round the hole to which one can jump: point at a ring where one sees it, and
## choose. The rings are seen as light shows them, bent; what is pointed at is found by the same
## bent ray.
##
## The rings lie level; the visitor looks down on them from `latitude_degrees`, here and wherever a
## jump leads, and has the hole before the same side afterwards.

## The ring that is pointed at, in Schwarzschild radii; 0: none.
signal pointed_at_ring(radius: float)
signal jumped(radius: float)

@export var rig: XrRig
@export var head: Node3D
@export var sky: BlackHoleSky
## Draws the rings; visible while one can point at them.
@export var rings: AccretionDisk
## Schwarzschild radii, rising.
@export var radii: PackedFloat32Array = [3.0, 4.0, 6.0, 10.0, 20.0]:
	set(value):
		radii = value
		_dress()
## How far above the rings' plane a jump leads, seen from the hole.
@export_range(5.0, 45.0, 1.0, "degrees") var latitude_degrees: float = 15.0
@export_range(0.5, 5.0, 0.1, "suffix:s") var dwell: float = 1.6
## One can point at a ring from so near: ratio of the radii.
@export_range(1.02, 1.5) var reach: float = 1.15
@export var enabled: bool = true:
	set(value):
		enabled = value
		_dress()

var _ring: int = -1
var _aimed: int = -1
## From the hole to the place on the ring that is pointed at.
var _aimed_towards: Vector3
var _resting := SkyObserver.new()


func _ready() -> void:
	_dress()


## The ring that is pointed at, in Schwarzschild radii; 0: none.
func get_ring() -> float:
	return radii[_ring] if _ring >= 0 else 0.0


func distance_along(from: Vector3, direction: Vector3) -> float:
	_aimed = -1
	if not enabled or not _is_there_a_hole():
		return INF
	# What the eye sees where the ray comes to the hole: a hand points at pictures, not at places.
	var eye := head.global_position
	var ahead := (sky.global_position - eye).normalized()
	var towards := direction.dot(ahead)
	if towards < 0.02:
		return INF
	var distance := (sky.global_position - from).dot(ahead) / towards
	if distance <= 0.0:
		return INF
	var seen := (from + direction * distance - eye).normalized()
	var place := (eye - sky.global_position) / sky.schwarzschild_radius
	var crossing := _observer().plane_crossing(place, seen, Vector3.UP, 0)
	if crossing.is_empty():
		return INF
	_aimed = _nearest_ring(crossing["radius"])
	_aimed_towards = crossing["position"]
	return distance if _aimed >= 0 else INF


func point_at(_place: Vector3) -> void:
	_show_ring(_aimed)


func leave() -> void:
	_show_ring(-1)


func dwell_seconds() -> float:
	return dwell


func what_is_pointed_at() -> Variant:
	if _aimed < 0:
		return null
	return _aimed


func choose() -> bool:
	if _aimed < 0:
		return false
	var radius := radii[_aimed]
	rig.blink(jump.bind(radius, XrRig.azimuth_of(_aimed_towards)))
	return true


## Jumps to the ring at `radius` (Schwarzschild radii), in the direction `azimuth` seen from the
## hole (radians to the left of -z). The hole is seen on the same side as before.
func jump(radius: float, azimuth: float) -> void:
	var turn := angle_difference(XrRig.azimuth_of(rig.get_place()), azimuth)
	rig.jump_to(stand(radius, azimuth))
	rig.snap(turn)
	jumped.emit(radius)


## Where the head is after a jump to `radius`, metres from the hole's centre.
func stand(radius: float, azimuth: float) -> Vector3:
	var latitude := deg_to_rad(latitude_degrees)
	var level := Vector3(-sin(azimuth), 0.0, -cos(azimuth))
	var outward := level * cos(latitude) + Vector3.UP * sin(latitude)
	return outward * radius * sky.schwarzschild_radius


## Angular radius of the shadow for somebody at rest there, radians.
static func shadow_there(radius: float) -> float:
	var observer := SkyObserver.new()
	observer.motion = LensingTable.MOTION_STATIC
	return observer.shadow(Vector3(0.0, 0.0, radius)).get("half_angle", 0.0)


func _observer() -> SkyObserver:
	return sky.observer if sky.observer != null else _resting


func _nearest_ring(radius: float) -> int:
	var nearest := -1
	var least := log(reach)
	for i in radii.size():
		var off := absf(log(radius / radii[i]))
		if off < least:
			least = off
			nearest = i
	return nearest


func _is_there_a_hole() -> bool:
	return sky.lensing > 0.99


func _show_ring(ring: int) -> void:
	if ring == _ring:
		return
	_ring = ring
	rings.ring_highlight = ring
	pointed_at_ring.emit(get_ring())


func _dress() -> void:
	if rings == null:
		return
	rings.visible = enabled
	rings.look = AccretionDisk.LOOK_RINGS
	rings.ring_radii = radii
