# SPDX-License-Identifier: MIT
class_name VisitStrip
extends Node
## Walks through a visit by itself, on a simulated headset, and keeps what the left eye sees: a
## picture of each station, some of each ride, and all of them as a strip.
##
##     ./run xr --strip OUT/

## On the command line of the scene, with the folder after it.
const OPTION: String = "--strip"
const STRIP_FILE: String = "strip.png"
const COLUMNS: int = 4
## Pictures in the strip are so wide, pixels.
const STRIP_WIDTH: int = 320
## Of the visitor, metres.
const EYES := Vector3(0.0, 1.6, 0.0)
## A headset that does not exist shows small pictures: they are drawn so much larger.
const SCALE: float = 2.0
const PATIENCE_SECONDS: float = 30.0
## Distances on the fall, in Schwarzschild radii, and times on the orbit, seconds.
const FALL: PackedFloat32Array = [9.0, 4.0, 2.0, 1.0, 0.5, 0.2]
const ORBIT_SECONDS: PackedFloat32Array = [0.5, 4.0, 8.0]

@export var scene: XrScene

var _folder: String
var _headset := SimulatedHeadset.new()
var _encoder := DisplayEncoder.new()
var _all: Array[Image] = []


## The folder that the command line names; empty: no strip is wanted.
static func folder_from(arguments: PackedStringArray) -> String:
	var at := arguments.find(OPTION)
	return arguments[at + 1] if at >= 0 and at + 1 < arguments.size() else ""


## Goes through all stations and ends the program.
func walk(folder: String) -> void:
	_folder = folder
	DirAccess.make_dir_recursive_absolute(folder)
	add_child(_encoder)
	scene.quality.enabled = false
	scene.spectator.mode = Spectator.Mode.OFF
	if not await _begin():
		printerr("xr: the strip needs the simulated headset: ./run xr --strip OUT/")
		get_tree().quit(1)
		return
	await _stations()
	await _orbit()
	await _fall()
	_join()
	print("xr: %d pictures and %s are in %s" % [_all.size(), STRIP_FILE, folder])
	get_tree().quit()


func _begin() -> bool:
	if not SimulatedHeadset.is_there() or not _headset.open():
		return false
	_look(Vector3.FORWARD)
	_put_hands_down()
	if not await _until(scene.session.has_focus) or not await _until(scene.has_started):
		return false
	scene.session.viewport.scaling_3d_scale = SCALE
	await _pause(0.5)
	scene.recentre()
	return true


func _stations() -> void:
	_look_at_hole()
	await _keep("arrival")
	scene.cards_shown = true
	await _pause(1.0)
	await _keep("card")
	scene.cards_shown = false
	scene.switches.toggle_lensing()
	await _pause(SkySwitches.LENSING_SECONDS + 0.5)
	await _keep("without_the_hole")
	scene.switches.toggle_lensing()
	await _pause(SkySwitches.LENSING_SECONDS + 0.5)
	scene.rings_shown = true
	var dwell := scene.jump.dwell
	scene.jump.dwell = INF  # until the picture is kept
	_look_at(scene.sky.global_position + _outward() * 3.0 * scene.sky.schwarzschild_radius)
	await _until(func() -> bool: return scene.jump.get_ring() == 3.0)
	await _keep("ring")
	scene.jump.dwell = dwell
	await _until(func() -> bool: return absf(scene.rig.get_radius() - 3.0) < 0.1)
	scene.rings_shown = false
	_look_at_hole()
	await _pause(1.0)
	await _keep("at_the_ring")
	scene.recentre()
	await _pause(0.5)
	_look(Vector3.FORWARD)
	scene.menu.open(scene.head.global_transform)
	await _pause(0.5)
	await _keep("menu")
	scene.menu.close()
	_look_at_hole()
	scene.sky.get_node(^"Disk").show()
	await _keep("disk")
	scene.sky.get_node(^"Disk").hide()


func _orbit() -> void:
	await _ride(XrRides.Kind.ORBIT_RIGHT)
	for seconds in ORBIT_SECONDS:
		await _until(_has_come.bind(seconds))
		await _keep("orbit_%04.1f_s" % seconds)
	await _end_ride()


func _fall() -> void:
	await _ride(XrRides.Kind.FALL)
	for radius in FALL:
		var fall := scene.rides.ride as FallRide
		fall.seek(fall.progress_of(radius))
		# Inside, the sky is beside and behind.
		_look(Vector3.FORWARD if radius > 0.7 else Vector3(1.0, 0.0, -0.1))
		await _pause(1.5)  # the exposure follows
		fall.seek(fall.progress_of(radius))
		await _keep("fall_%04.1f_rs" % radius)
	await _end_ride()
	await _keep("back")


func _ride(kind: XrRides.Kind) -> void:
	scene.rides.countdown_seconds = 0
	scene.rides.start(kind)
	await _until(func() -> bool: return scene.rides.ride != null)
	await _until(func() -> bool: return not scene.rig.is_blinking())
	_look(Vector3.FORWARD)


func _end_ride() -> void:
	scene.rides.leave()
	await _until(func() -> bool: return not scene.rides.is_on())
	await _until(func() -> bool: return not scene.rig.is_blinking())
	_look_at_hole()


func _has_come(seconds: float) -> bool:
	var rate := scene.rides.pace.rate(scene.rides.ride.get_place().length())
	return scene.rides.ride.get_proper_time() >= rate * seconds


# Keeps what the left eye sees now.
func _keep(picture_name: String) -> void:
	await _pause(0.3)
	var taken := await EyeCapture.take(scene.head, PATIENCE_SECONDS)
	if taken.is_empty():
		printerr("xr: the runtime gave no picture of %s." % picture_name)
		return
	var picture := await _encoder.encode(taken[0])
	var file := _folder.path_join("%02d_%s.png" % [_all.size() + 1, picture_name])
	if picture.save_png(file) != OK:
		printerr("xr: %s cannot be written. Check folder and disk." % file)
	_all.append(picture)


func _join() -> void:
	if _all.is_empty():
		return
	var size := _all[0].get_size()
	var height := roundi(float(STRIP_WIDTH) * size.y / size.x)
	var rows := ceili(float(_all.size()) / COLUMNS)
	var strip := Image.create_empty(
		COLUMNS * STRIP_WIDTH, rows * height, false, _all[0].get_format()
	)
	for i in _all.size():
		var small := _all[i].duplicate() as Image
		small.resize(STRIP_WIDTH, height, Image.INTERPOLATE_LANCZOS)
		var at := Vector2i(i % COLUMNS * STRIP_WIDTH, floori(float(i) / COLUMNS) * height)
		strip.blit_rect(small, Rect2i(Vector2i.ZERO, small.get_size()), at)
	strip.save_png(_folder.path_join(STRIP_FILE))


func _look_at_hole() -> void:
	_look_at(scene.sky.global_position)


# Turns the simulated head so that it looks at a place in the world.
func _look_at(place: Vector3) -> void:
	_look(scene.rig.get_room().affine_inverse() * place - EYES)


func _look(direction: Vector3) -> void:
	_headset.head = Transform3D(Basis.looking_at(direction), EYES)
	_headset.send()


# From the hole to the visitor, level.
func _outward() -> Vector3:
	return (scene.rig.get_place() * Vector3(1.0, 0.0, 1.0)).normalized()


func _put_hands_down() -> void:
	_headset.left.active = false
	_headset.right.active = false
	_headset.send()


func _pause(seconds: float) -> void:
	await get_tree().create_timer(seconds).timeout
	for frame in 3:
		await get_tree().process_frame


func _until(is_so: Callable) -> bool:
	return await Waiting.until(get_tree(), is_so, PATIENCE_SECONDS)
