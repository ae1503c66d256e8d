# SPDX-License-Identifier: MIT
extends RigCase
## A tour in the headset: each station stands before the visitor, level, falls go the exact way, and
## afterwards the room is as it was.

const FILE: String = "res://scenes/tour/black_hole_tour.tres"

var _guide: TourGuide
var _stage: XrTourStage
var _choice: ObserverChoice


func before_each() -> void:
	super()
	comfort.blinks = false
	var disk := AccretionDisk.new()
	sky.add_child(disk)
	var switches := SkySwitches.new()
	var disk_switches := DiskSwitches.new()
	_choice = ObserverChoice.new()
	_stage = XrTourStage.new()
	_guide = TourGuide.new()
	switches.sky = sky
	disk_switches.disk = disk
	_choice.sky = sky
	_stage.sky = sky
	_stage.rig = rig
	_stage.choice = _choice
	_stage.switches = switches
	_stage.disk = disk_switches
	_guide.stage = _stage
	for node: Node in [switches, disk_switches, _choice, _stage, _guide]:
		put(node)
	_guide.set_process(false)
	head.rotation.y = 0.7


func _begin(id: StringName) -> TourStation:
	var tour := TourFile.read(FILE).tour
	for i in tour.stations.size():
		if tour.stations[i].id == id:
			assert_true(_guide.start(tour, i))
			return tour.stations[i]
	fail_test("no station %s" % id)
	return null


func _elapse(seconds: float) -> void:
	for i in roundi(seconds * 20.0):
		_guide.advance(0.05)


func _bearing(direction: Vector3) -> Vector3:
	return (head.global_basis.inverse() * direction).normalized()


func test_every_station_stands_where_it_says() -> void:
	var tour := TourFile.read(FILE).tour
	for station in tour.stations:
		_begin(station.id)
		assert_true(_stage.is_arrived())
		assert_almost_eq(rig.get_radius() / station.radius, 1.0, 1e-3, station.title)
		assert_almost_eq(rig.get_place().y, 0.0, 1e-2, "level")
		var towards := Vector3.FORWARD
		match station.look:
			TourStation.Look.AWAY:
				towards = Vector3.BACK
			TourStation.Look.ALONG:
				towards = Vector3.LEFT
		assert_almost_eq(_bearing(-rig.get_place()), towards, Vector3.ONE * 1e-3, station.title)
		var place := rig.get_place() / sky.schwarzschild_radius
		assert_eq(sky.observer.get_refusal(place), "", station.title)


func test_the_sky_is_turned_so_that_the_right_part_is_behind_the_hole() -> void:
	var station := _begin(&"einstein_ring")
	var behind := sky.global_basis * station.get_direction_behind()
	assert_almost_eq(behind, -rig.get_place().normalized(), Vector3.ONE * 1e-3)


func test_the_head_moves_freely_where_it_stands() -> void:
	_begin(&"far_away")
	var before := rig.get_place()
	head.position += Vector3(0.1, 0.05, 0.0)
	_elapse(0.5)
	assert_almost_eq(rig.get_place() - before, Vector3(0.1, 0.05, 0.0), Vector3.ONE * 1e-3)


func test_a_fall_goes_along_the_exact_way_and_waits() -> void:
	_begin(&"fall")
	_elapse(12.0)
	var exact := RadialFallPath.new()
	exact.start_from_rest(8.0 + XrRides.LEANING)
	var radius := exact.radius_at(_stage.ride.get_proper_time())
	assert_almost_eq(rig.get_radius() / radius, 1.0, 1e-3)
	assert_eq(sky.observer.motion, LensingTable.MOTION_INFALL)
	_guide.next()
	_guide.next()
	assert_lte(_stage.ride.get_place().length(), 1.001)
	_guide.automatic = false
	_elapse(120.0)
	assert_almost_eq(_stage.ride.get_place().length(), _guide.get_station().waits_at, 0.02)


func test_a_pause_holds_the_fall() -> void:
	_begin(&"fall")
	_guide.set_paused(true)
	var before := rig.get_place()
	_elapse(2.0)
	assert_eq(rig.get_place(), before)


func test_captions_lead_nearer() -> void:
	_begin(&"shadow_sizes")
	for i in 3:
		_guide.next()
	assert_almost_eq(rig.get_radius(), 2.5, 1e-3)


func test_everything_is_as_before_when_it_is_over() -> void:
	var room := rig.get_room()
	sky.rotation = Vector3(0.1, 0.2, 0.3)
	sky.exposure = 1.2
	var pose := sky.global_transform
	_begin(&"fall")
	_elapse(15.0)
	_guide.next_station()
	_elapse(2.0)
	_guide.leave()
	assert_eq(rig.get_room(), room)
	assert_eq(sky.global_transform, pose)
	assert_almost_eq(sky.schwarzschild_radius, 0.5, 1e-6)
	assert_almost_eq(sky.exposure, 1.2, 1e-5)
	assert_eq(_choice.get_kind(), ObserverKind.Kind.STATIC)
	assert_false(_choice.resting)


func test_the_whole_tour_runs_by_itself() -> void:
	watch_signals(_guide)
	_guide.begin()
	for i in 700:
		_elapse(1.0)
		if not _guide.is_on():
			break
	assert_signal_emitted_with_parameters(_guide, "finished", [true])
