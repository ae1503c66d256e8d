# SPDX-License-Identifier: MIT
extends GutTest
## Views of a tour: the hole stands where the station says, on the way as well.


func _station() -> TourStation:
	var station := TourStation.new()
	station.captions.append(TourCaption.new())
	return station


# Right, up and forwards of a direction of the sky, in the picture's axes.
func _seen(view: TourView, direction: Vector3) -> Vector3:
	return view.get_orientation().inverse() * direction.normalized()


func test_the_hole_is_ahead_and_what_is_chosen_behind_it() -> void:
	var view := TourView.of_station(_station())
	var centre := StartView.sky_direction(StartView.GALACTIC_CENTRE)
	assert_almost_eq(view.get_place(), -centre * 12.0, Vector3.ONE * 1e-3)
	assert_almost_eq(_seen(view, centre), Vector3.FORWARD, Vector3.ONE * 1e-5)


func test_without_roll_north_is_up() -> void:
	var view := TourView.of_station(_station())
	assert_almost_eq(_seen(view, Vector3.UP).x, 0.0, 1e-5)
	assert_gt(_seen(view, Vector3.UP).y, 0.0)


func test_roll_leans_north_to_the_right() -> void:
	var station := _station()
	station.roll = 30.0
	var north := _seen(TourView.of_station(station), Vector3.UP)
	assert_almost_eq(rad_to_deg(atan2(north.x, north.y)), 30.0, 1e-3)


func test_looks() -> void:
	var station := _station()
	var hole := station.get_direction_behind()
	station.look = TourStation.Look.AWAY
	assert_almost_eq(_seen(TourView.of_station(station), hole), Vector3.BACK, Vector3.ONE * 1e-5)
	station.look = TourStation.Look.ALONG
	assert_almost_eq(_seen(TourView.of_station(station), hole), Vector3.LEFT, Vector3.ONE * 1e-5)
	station.look = TourStation.Look.HOLE
	station.look_offset = Vector2(20.0, 0.0)
	var aside := _seen(TourView.of_station(station), hole)
	assert_almost_eq(rad_to_deg(atan2(aside.x, -aside.z)), -20.0, 1e-3, "to its left")
	station.look_offset = Vector2(0.0, 20.0)
	assert_lt(_seen(TourView.of_station(station), hole).y, -0.3, "below")


func test_between_two_views_the_hole_stays_in_the_middle() -> void:
	var from := TourView.of_station(_station())
	var station := _station()
	station.behind = Vector2(84.0, 1.0)
	station.radius = 50.0
	station.field_of_view = 20.0
	var to := TourView.of_station(station)
	for step in 11:
		var view := TourView.between(from, to, 0.1 * step)
		assert_almost_eq(
			_seen(view, -view.get_place()), Vector3.FORWARD, Vector3.ONE * 1e-4, str(step)
		)
	assert_almost_eq(TourView.between(from, to, 0.5).get_radius(), sqrt(12.0 * 50.0), 1e-3)
	assert_true(TourView.between(from, to, 1.0).is_like(to))
	assert_false(TourView.between(from, to, 0.9).is_like(to))


func test_it_is_what_a_rig_sees() -> void:
	var rig := ViewRig.new()
	StartView.apply_to(rig)
	rig.turn(0.4, -0.2, 0.3)
	var view := TourView.of_rig(rig, 55.0)
	assert_almost_eq(view.get_place(), rig.get_position(), Vector3.ONE * 1e-4)
	assert_lt(view.get_orientation().angle_to(rig.get_orientation()), 1e-3)
	assert_almost_eq(view.get_field(), 55.0, 1e-4)
