# SPDX-License-Identifier: MIT
extends GutTest
## The first view and the sizes of things in it.


func test_sky_directions_follow_the_world_axes() -> void:
	var origin := StartView.sky_direction(Vector2(0.0, 0.0))
	var six_hours := StartView.sky_direction(Vector2(90.0, 0.0))
	var pole := StartView.sky_direction(Vector2(12.0, 90.0))
	assert_almost_eq(origin, Vector3.RIGHT, Vector3.ONE * 1e-6)
	assert_almost_eq(six_hours, Vector3.FORWARD, Vector3.ONE * 1e-6)
	assert_almost_eq(pole, Vector3.UP, Vector3.ONE * 1e-6)


func test_galactic_centre_and_pole_are_square() -> void:
	var centre := StartView.sky_direction(StartView.GALACTIC_CENTRE)
	var pole := StartView.sky_direction(StartView.GALACTIC_POLE)
	assert_almost_eq(centre.dot(pole), 0.0, 1e-3)


func test_the_galactic_centre_stands_behind_the_hole() -> void:
	var rig := ViewRig.new()
	StartView.apply_to(rig)
	var forward := rig.get_orientation() * Vector3.FORWARD
	var off := rad_to_deg(forward.angle_to(StartView.sky_direction(StartView.GALACTIC_CENTRE)))
	assert_almost_eq(off, StartView.OFFSET.length(), 0.2)
	assert_almost_eq(rig.get_distance(), StartView.DISTANCE, 1e-4)
	var inward := -rig.get_position().normalized()
	assert_lt(forward.distance_to(inward), 1e-5, "looks at the hole")


func test_sizes_follow_the_window() -> void:
	assert_almost_eq(PictureScale.text_scale(Vector2i(1280, 720)), 1.0, 1e-6)
	assert_almost_eq(PictureScale.text_scale(Vector2i(1920, 1080)), 1.5, 1e-6)
	assert_almost_eq(PictureScale.text_scale(Vector2i(3840, 2160)), 3.0, 1e-6)
	assert_almost_eq(PictureScale.text_scale(Vector2i(720, 1280)), 0.75, 1e-6, "narrow window")
	assert_almost_eq(PictureScale.text_scale(Vector2i(1, 1)), 0.75, 1e-6)
	assert_gt(PictureScale.star_sigma(1080.0), PictureScale.star_sigma(720.0))
	assert_almost_eq(PictureScale.star_sigma(1.0), PictureScale.LEAST_SIGMA, 1e-6)
