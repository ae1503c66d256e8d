# SPDX-License-Identifier: MIT
extends GutTest
## What a shot in JSON may say: defaults, every key, and what is refused, by name.

const REPEATED: String = "res://tests/data/cie1931_2deg_1nm.csv"

var _folder := ScratchFolder.new("shots")


func test_defaults() -> void:
	var spec := ShotSpec.from_data({"position_rs": [0, 0, 10]})
	assert_eq(spec.error, "")
	assert_eq(spec.resolution, Vector2i(1280, 720))
	assert_eq(spec.vertical_fov_deg, 60.0)
	assert_eq(spec.position, PackedFloat64Array([0.0, 0.0, 10.0]))
	assert_eq(spec.forward, PackedFloat64Array([0.0, 0.0, -1.0]))
	assert_eq(spec.up, PackedFloat64Array([0.0, 1.0, 0.0]))
	assert_eq(spec.observer.motion, LensingTable.MOTION_STATIC)
	assert_eq(spec.renderer, "mobile")
	assert_true(spec.has_stars)
	assert_eq(spec.catalogue, "builtin")
	assert_eq(spec.magnitude_limit, 7.0)
	assert_eq(spec.orders, 2)
	assert_true(spec.lensing)
	assert_eq(spec.psf_sigma_px, 1.0)
	assert_eq(spec.exposure_ev, 0.0)
	assert_eq(spec.background, ShotSpec.Background.NONE)


func test_every_key() -> void:
	var catalogue := _folder.write_text("stars.csv", "ra_deg,dec_deg,vmag\n1,2,3\n")
	var spec := (
		ShotSpec
		. from_data(
			{
				"resolution": [640, 480],
				"vertical_fov_deg": 0.5,
				"position_rs": [0.1, 0.2, 0.2],
				"look_at_rs": [0.1, 0.2, 5],
				"aim": "axes",
				"up": [1, 0, 0],
				"observer": "rain",
				"renderer": "forward_plus",
				"stars":
				{
					"catalogue": catalogue,
					"magnitude_limit": 12.5,
					"orders": 4,
					"lensing": false,
					"psf_sigma_px": 0.7,
					"exposure_ev": -2,
				},
				"background": "milky_way",
			}
		)
	)
	assert_eq(spec.error, "")
	assert_eq(spec.resolution, Vector2i(640, 480))
	assert_eq(spec.vertical_fov_deg, 0.5)
	assert_eq(spec.forward, PackedFloat64Array([0.0, 0.0, 1.0]))
	assert_eq(spec.up, PackedFloat64Array([1.0, 0.0, 0.0]))
	assert_eq(spec.observer.motion, LensingTable.MOTION_RAIN)
	assert_eq(spec.renderer, "forward_plus")
	assert_eq(spec.catalogue, catalogue)
	assert_eq(spec.magnitude_limit, 12.5)
	assert_eq(spec.orders, 4)
	assert_false(spec.lensing)
	assert_eq(spec.psf_sigma_px, 0.7)
	assert_eq(spec.exposure_ev, -2.0)
	assert_eq(spec.background, ShotSpec.Background.MILKY_WAY)


func test_automatic_exposure() -> void:
	var spec := ShotSpec.from_data({"position_rs": [0, 0, 10], "exposure": 2})
	assert_null(spec.auto_exposure)
	assert_eq(spec.exposure_ev, 2.0)
	spec = ShotSpec.from_data({"position_rs": [0, 0, 10], "exposure": "auto"})
	var sky: BlackHoleSky = autofree(BlackHoleSky.new())
	var least := sky.auto_exposure_min_ev
	var most := sky.auto_exposure_max_ev
	spec.auto_exposure.apply_to(sky)
	assert_true(sky.auto_exposure)
	assert_eq(sky.auto_exposure_min_ev, least, "the node's defaults")
	assert_eq(sky.auto_exposure_max_ev, most)
	var wish := {"mode": "auto", "compensation_ev": 1.5, "max_ev": -11, "min_ev": -12}
	spec = ShotSpec.from_data({"position_rs": [0, 0, 10], "exposure": wish})
	spec.auto_exposure.apply_to(sky)
	assert_eq(sky.exposure, 1.5)
	assert_eq(sky.auto_exposure_min_ev, -12.0)
	assert_eq(sky.auto_exposure_max_ev, -11.0)


func test_no_stars() -> void:
	var spec := ShotSpec.from_data({"position_rs": [0, 0, 10], "stars": null})
	assert_eq(spec.error, "")
	assert_false(spec.has_stars)


func test_aim_apparent_centres_the_hole() -> void:
	var spec := ShotSpec.from_data({"position_rs": [3, 0, 4], "aim": "apparent"})
	assert_eq(spec.error, "")
	_expect_vector(spec.forward, [-0.6, 0.0, -0.8])


func test_aiming_far_away_keeps_its_digits() -> void:
	# One radius beside a place 20,000 radii out: single precision would be off by pixels.
	var spec := (
		ShotSpec
		. from_data(
			{
				"position_rs": [20000.123456789, 3, -7],
				"look_at_rs": [20000.123456789, 3.6, -6.2],
				"up": [1, 0, 0],
			}
		)
	)
	assert_eq(spec.error, "")
	assert_almost_eq(spec.forward[0], 0.0, 1e-12)
	assert_almost_eq(spec.forward[1], 0.6, 1e-12)
	assert_almost_eq(spec.forward[2], 0.8, 1e-12)
	assert_almost_eq(Vec3D.dot(spec.up, spec.forward), 0.0, 1e-15)


func test_up_is_made_upright() -> void:
	var spec := ShotSpec.from_data({"position_rs": [0, 0, 10], "up": [0, 3, -5]})
	_expect_vector(spec.up, [0.0, 1.0, 0.0])
	# Looking straight down without a word about up is no mistake.
	spec = ShotSpec.from_data({"position_rs": [0, 10, 0]})
	assert_eq(spec.error, "")
	assert_almost_eq(Vec3D.dot(spec.up, spec.forward), 0.0, 1e-15)
	assert_almost_eq(Vec3D.length(spec.up), 1.0, 1e-15)


func test_refusals_name_the_key(
	# the key, what it is set to, words of the refusal
	p: Array = use_parameters(
		[
			["postion_rs", [0, 0, 1], "postion_rs is no key"],
			["resolution", "large", "resolution must"],
			["resolution", [640], "resolution must"],
			["resolution", [640.5, 480], "resolution must"],
			["resolution", [0, 480], "resolution must"],
			["resolution", [640, -480], "resolution must"],
			["resolution", [100000, 480], "8192"],
			["vertical_fov_deg", "wide", "vertical_fov_deg must"],
			["vertical_fov_deg", 0, "vertical_fov_deg must"],
			["vertical_fov_deg", 180, "vertical_fov_deg must"],
			["position_rs", null, "position_rs must"],
			["position_rs", [1, 2], "position_rs must"],
			["position_rs", [1, 2, "3"], "position_rs must"],
			["position_rs", [1, 2, NAN], "position_rs must"],
			["position_rs", [0, 0, 0], "singularity"],
			["position_rs", [0, 0, 1e13], "1e12"],
			["position_rs", [0, 0, 1], "static"],
			["position_rs", [0, 0.3, 0.4], "static"],
			["look_at_rs", [0, 0, 10], "look_at_rs"],
			["look_at_rs", 7, "look_at_rs must"],
			["aim", "sideways", "aim must"],
			["up", [0, 0, 2], "up points along"],
			["up", [0, 0, 0], "up points along"],
			["up", "up", "up must"],
			["observer", "orbiting", "observer must"],
			["observer", 1, "observer must"],
			["renderer", "vulkan", "renderer must"],
			["stars", [], "stars must"],
			["stars", {"catalog": "builtin"}, "stars.catalog is no key"],
			["stars", {"catalogue": 7}, "stars.catalogue must"],
			["stars", {"catalogue": "none.csv"}, "none.csv"],
			["stars", {"magnitude_limit": "7"}, "stars.magnitude_limit must"],
			["stars", {"magnitude_limit": 100}, "stars.magnitude_limit must"],
			["stars", {"orders": 0}, "stars.orders must"],
			["stars", {"orders": 5}, "stars.orders must"],
			["stars", {"orders": 1.5}, "stars.orders must"],
			["stars", {"lensing": 1}, "stars.lensing must"],
			["stars", {"psf_sigma_px": 0}, "stars.psf_sigma_px must"],
			["stars", {"psf_sigma_px": true}, "stars.psf_sigma_px must"],
			["stars", {"exposure_ev": INF}, "stars.exposure_ev must"],
			["background", null, "background must"],
			["background", "nebula", "nebula"],
			["background", "none.png", "none.png"],
		]
	)
) -> void:
	var data := {"position_rs": [0, 0, 10], p[0]: p[1]}
	assert_string_contains(ShotSpec.from_data(data).error, p[2])


func test_a_place_is_required() -> void:
	assert_string_contains(ShotSpec.from_data({}).error, "position_rs is missing")
	for data: Variant in [[], "shot", 7, null, true]:
		assert_string_contains(ShotSpec.from_data(data).error, "JSON object")


func test_aim_apparent_and_a_target_exclude_each_other() -> void:
	var data := {"position_rs": [0, 0, 10], "aim": "apparent", "look_at_rs": [0, 0, 0]}
	assert_string_contains(ShotSpec.from_data(data).error, "look_at_rs")


func test_rain_goes_inside_the_horizon() -> void:
	for r: float in [1.0, 0.5, 0.1, 0.001]:
		assert_eq(ShotSpec.from_data({"position_rs": [0, r, 0], "observer": "rain"}).error, "")


func test_without_the_hole_any_place_will_do() -> void:
	assert_true(ShotSpec.from_data({"position_rs": [0, 0, 10]}).hole)
	for r: float in [0.0, 0.5, 1.0, 10.0]:
		for observer: Variant in [
			"static", {"motion": "velocity", "beta": [0, 0.6, 0], "relative_to": "static"}
		]:
			var data := {
				"position_rs": [0, r, 0],
				"look_at_rs": [0, r, 7],
				"observer": observer,
				"hole": false
			}
			var spec := ShotSpec.from_data(data)
			assert_eq(spec.error, "")
			assert_false(spec.hole)
			_expect_vector(spec.forward, [0.0, 0.0, 1.0])
	var nowhere := {"position_rs": [0, 0, 0], "hole": false}
	assert_string_contains(ShotSpec.from_data(nowhere).error, "look_at_rs")


func test_shots_from_files() -> void:
	_folder.write_text("sky.csv", "ra_deg,dec_deg,vmag\n1,2,3\n")
	var shot := '{"position_rs": [0, 0, 9], "stars": {"catalogue": "sky.csv"}}'
	var spec := ShotSpec.from_file(_folder.write_text("shot.json", shot))
	assert_eq(spec.error, "")
	assert_eq(spec.catalogue, _folder.file("sky.csv"), "looked up beside the shot")
	spec = ShotSpec.from_data({"position_rs": [0, 0, 9], "background": REPEATED})
	assert_string_contains(spec.error, "cie1931", "no picture")


func test_files_that_are_no_shots() -> void:
	assert_string_contains(ShotSpec.from_file("res://no/such.json").error, "res://no/such.json")
	var path := _folder.write_text("empty.json", "")
	assert_string_contains(ShotSpec.from_file(path).error, "empty.json")
	path = _folder.write_text("broken.json", '{\n"position_rs": [0, 0,\n')
	assert_string_contains(ShotSpec.from_file(path).error, "line")


func _expect_vector(got: PackedFloat64Array, expected: PackedFloat64Array) -> void:
	assert_lt(Vec3D.length(Vec3D.subtract(got, expected)), 1e-15, "%s, not %s" % [got, expected])
