# SPDX-License-Identifier: MIT
extends GutTest
## Where a line of sight crosses a plane through the hole, as scripts ask for it.

const REFERENCE: String = "res://gdextension/tests/data/disk_static.csv"

var _observer := SkyObserver.new()


func before_each() -> void:
	_observer.motion = LensingTable.MOTION_STATIC


## The reference knows radii to many digits; the vectors of scripts are single precision.
func test_radii_are_those_of_the_reference() -> void:
	var file := FileAccess.open(REFERENCE, FileAccess.READ)
	file.get_line()
	file.get_line()
	var seen := 0
	var none := 0
	while not file.eof_reached():
		var row := file.get_csv_line()
		if row.size() < 10:
			continue
		var inclination := row[1].to_float()
		var xi := row[2].to_float()
		var psi := row[3].to_float()
		var place := Vector3(0.0, 0.0, 1.0 / row[0].to_float())
		var direction := Vector3(sin(xi) * cos(psi), -sin(xi) * sin(psi), -cos(xi))
		var normal := 3.0 * Vector3(sin(inclination), 0.0, cos(inclination))
		for order in 2:
			var expected := row[4 + 2 * order].to_float() if row[4 + 2 * order] != "nan" else NAN
			var found := _observer.plane_crossing(place, direction, normal, order)
			if is_nan(expected):
				none += 1
				assert_true(found.is_empty() or found["radius"] > 1e3, "%s order %d" % [row, order])
			elif expected < 100.0 and expected > 2.0:
				seen += 1
				var radius: float = found["radius"]
				assert_almost_eq(radius / expected, 1.0, 2e-3, "%s order %d" % [row, order])
				var position: Vector3 = found["position"]
				assert_almost_eq(position.length() / radius, 1.0, 1e-5)
				assert_almost_eq(position.dot(normal) / radius, 0.0, 1e-4, "on the plane")
	assert_gt(seen, 100, "crossings compared")
	assert_gt(none, 50, "lines of sight that do not come so far")


func test_far_from_the_hole_light_goes_straight() -> void:
	var place := Vector3(3000.0, 4000.0, 0.0)
	var towards := Vector3(-2000.0, -4000.0, 500.0)
	var found := _observer.plane_crossing(place, towards, Vector3.UP, 0)
	var position: Vector3 = found["position"]
	assert_lt(position.distance_to(Vector3(1000.0, 0.0, 500.0)), 15.0, "%s" % position)
	assert_true(_observer.plane_crossing(place, -towards, Vector3.UP, 0).is_empty(), "away from it")
	assert_true(_observer.plane_crossing(place, towards, Vector3.UP, 1).is_empty(), "only once")


func test_both_sides_of_the_plane_see_alike() -> void:
	for height: float in [0.5, 4.0]:
		var place := Vector3(1.0, height, 9.0)
		var direction := Vector3(0.35, -0.1 * height, -1.0)
		var mirror := Vector3(1.0, -1.0, 1.0)
		for order in 2:
			var above := _observer.plane_crossing(place, direction, Vector3.UP, order)
			var below := _observer.plane_crossing(
				place * mirror, direction * mirror, Vector3.UP, order
			)
			var turned := _observer.plane_crossing(place, direction, Vector3.DOWN, order)
			assert_eq(above.has("radius"), below.has("radius"))
			if above.has("radius"):
				assert_almost_eq(above["radius"], below["radius"], 1e-5)
				assert_almost_eq(above["radius"], turned["radius"], 1e-9)
				var from_below: Vector3 = below["position"]
				assert_almost_eq(above["position"], from_below, Vector3.ONE * 1e-4)


## Also where rounding has put the observer a little off.
func test_an_observer_on_the_plane_does_not_meet_it_where_he_is() -> void:
	for height: float in [0.0, 1e-6, -1e-6]:
		var place := Vector3(0.0, height, 8.0)
		for up: float in [0.3, -0.3]:
			var found := _observer.plane_crossing(place, Vector3(0.0, up, -1.0), Vector3.UP, 0)
			var position: Vector3 = found["position"]
			assert_lt(position.z, -1.0, "beyond the hole: %s" % position)
		var along := _observer.plane_crossing(place, Vector3(0.4, 0.0, -1.0), Vector3.UP, 0)
		assert_true(along.is_empty(), "a line of sight in the plane crosses it nowhere")


func test_where_there_is_no_such_observer_it_says_so() -> void:
	assert_true(_observer.plane_crossing(Vector3(0, 0, 0.5), Vector3.UP, Vector3.UP, 0).is_empty())
	assert_push_error("plane_crossing")
	assert_true(
		_observer.plane_crossing(Vector3(0, 1, 5), Vector3.FORWARD, Vector3.ZERO, 0).is_empty()
	)
	assert_push_error("normal")
