# SPDX-License-Identifier: MIT
extends GutTest
## The node: properties and their limits, warnings with their remedies, life without its resources.

const TABLE: String = "res://addons/blackhole_sky/data/schwarzschild.lut"

var _folder := ScratchFolder.new("sky")
var _sky: BlackHoleSky


func before_each() -> void:
	_sky = autofree(BlackHoleSky.new())


func test_defaults() -> void:
	assert_eq(_sky.schwarzschild_radius, 1.0)
	assert_eq(_sky.lensing, 1.0)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_STATIC)
	assert_null(_sky.table)
	assert_null(_sky.catalogue)
	assert_true(_sky.stars_visible)
	assert_eq(_sky.image_orders, 2)
	assert_eq(_sky.psf_model, BlackHoleSky.PSF_GAUSSIAN)
	assert_eq(_sky.psf_sigma, 1.0)
	assert_eq(_sky.aperture_mm, 5.0)
	assert_eq(_sky.glare, 0.616)
	assert_eq(_sky.exposure, 0.0)
	assert_false(_sky.auto_exposure)
	assert_eq(_sky.auto_exposure_min_ev, -10.0)
	assert_eq(_sky.auto_exposure_max_ev, 6.0)
	assert_eq(_sky.adaptation_speed, 1.0)
	assert_eq(_sky.background, BlackHoleSky.BACKGROUND_NONE)
	assert_null(_sky.panorama)
	assert_eq(_sky.render_layers, 1)


func test_properties_keep_what_they_are_given_within_limits(
	# property, value, what it becomes
	p: Array = use_parameters(
		[
			["schwarzschild_radius", 2.5, 2.5],
			["schwarzschild_radius", -1.0, 1e-6],
			["mass_solar", 4.3e6, 4.3e6],
			["mass_solar", -1.0, 1e-12],
			["lensing", 0.25, 0.25],
			["effect_deflection", false, false],
			["effect_aberration", false, false],
			["effect_gravitational_shift", false, false],
			["effect_doppler", false, false],
			["effect_magnification", false, false],
			["effect_higher_orders", false, false],
			["saturation", 2.0, 2.0],
			["saturation", 9.0, 4.0],
			["stereo_baseline_scale", 0.3, 0.3],
			["stereo_baseline_scale", 2.0, 1.0],
			["redshift_map", true, true],
			["panorama_is_light", false, false],
			["lensing", 7.0, 1.0],
			["lensing", -1.0, 0.0],
			["observer_motion", 1, 1],
			["stars_visible", false, false],
			["magnitude_limit", 6.5, 6.5],
			["magnitude_limit", 1000.0, 99.0],
			["image_orders", 3, 3],
			["image_orders", 0, 1],
			["image_orders", 9, 4],
			["psf_sigma", 1.5, 1.5],
			["psf_sigma", 0.0, 0.3],
			["psf_sigma", 1e3, 32.0],
			["psf_model", BlackHoleSky.PSF_AIRY, 1],
			["psf_model", 7, BlackHoleSky.PSF_EYE],
			["psf_model", -1, BlackHoleSky.PSF_GAUSSIAN],
			["aperture_mm", 2.5, 2.5],
			["aperture_mm", 0.0, 0.1],
			["aperture_mm", 1e6, 1e4],
			["glare", 0.25, 0.25],
			["glare", -1.0, 0.0],
			["glare", 2.0, 1.0],
			["faint_limit", 1e-3, 1e-3],
			["faint_limit", 0.0, 1e-9],
			["exposure", -3.5, -3.5],
			["exposure", 1e3, 60.0],
			["auto_exposure", true, true],
			["auto_exposure_min_ev", -3.5, -3.5],
			["auto_exposure_min_ev", -1e3, -40.0],
			["auto_exposure_max_ev", 3.5, 3.5],
			["auto_exposure_max_ev", 1e3, 60.0],
			["adaptation_speed", 2.5, 2.5],
			["adaptation_speed", -1.0, 0.0],
			["background", 1, 1],
			["panorama_luminance", 0.5, 0.5],
			["panorama_luminance", -0.5, 0.0],
			["render_layers", 6, 6],
		]
	)
) -> void:
	var property: String = p[0]
	_sky.set(property, p[1])
	assert_eq(_sky.get(property), p[2], property)


func test_numbers_that_are_none_are_not_taken_over(
	property: String = use_parameters(
		[
			"schwarzschild_radius",
			"lensing",
			"magnitude_limit",
			"psf_sigma",
			"aperture_mm",
			"glare",
			"faint_limit",
			"exposure",
			"auto_exposure_min_ev",
			"auto_exposure_max_ev",
			"adaptation_speed",
			"panorama_luminance",
		]
	)
) -> void:
	_sky.set(property, NAN)
	assert_true(is_finite(_sky.get(property)), property)


func test_resources_are_held_and_let_go() -> void:
	var table := LensingTable.new()
	var stars := StarCatalogue.new()
	_sky.table = table
	_sky.catalogue = stars
	assert_same(_sky.table, table)
	assert_same(_sky.catalogue, stars)
	assert_gt(table.get_signal_connection_list("changed").size(), 0)
	_sky.table = null
	_sky.catalogue = null
	assert_eq(table.get_signal_connection_list("changed").size(), 0)
	assert_eq(stars.get_signal_connection_list("changed").size(), 0)
	_sky.table = table
	_sky.table = table
	assert_eq(table.get_signal_connection_list("changed").size(), 1, "set twice")


func test_distances_and_shadows() -> void:
	add_child(_sky)
	assert_eq(_sky.shadow_angle_at(Vector3.ONE), 0.0, "no table, no hole to be seen")
	_sky.table = LensingTable.new()
	_sky.table.load_file(TABLE)
	_sky.position = Vector3(1, 2, 3)
	_sky.schwarzschild_radius = 2.0
	assert_almost_eq(_sky.distance_to(Vector3(1, 2, 23)), 10.0, 1e-6)
	var angle := _sky.shadow_angle_at(Vector3(1, 2, 23))
	assert_almost_eq(rad_to_deg(angle), 2 * 14.2690273279, 1e-5)
	_sky.lensing = 0.5
	angle = _sky.shadow_angle_at(Vector3(1, 2, 13))
	assert_almost_eq(rad_to_deg(angle), 2 * 14.2690273279, 1e-5, "half the mass")
	_sky.lensing = 1.0
	angle = _sky.shadow_angle_at(Vector3(1, 2, 4))
	assert_almost_eq(
		angle, LensingTable.shadow_angle(0.5, LensingTable.MOTION_RAIN), 1e-6, "inside"
	)
	_sky.observer_motion = LensingTable.MOTION_RAIN
	assert_almost_eq(rad_to_deg(_sky.shadow_angle_at(Vector3(1, 2, 5))), 84.2068977, 1e-5)


func test_warnings_name_the_remedy() -> void:
	_expect_warning("no lensing table", "schwarzschild.lut")
	_expect_warning("no stars", "hipparcos.stars")
	_sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	_expect_warning("panorama", "Set `panorama`")
	_sky.table = LensingTable.new()
	_sky.catalogue = StarCatalogue.new()
	_expect_warning("no lensing table", "bake()")
	_expect_warning("no stars", "CSV")
	_sky.table.load_file(TABLE)
	_sky.catalogue.set_stars([Vector3.UP], [1.0])
	_sky.background = BlackHoleSky.BACKGROUND_GRID
	assert_eq(_sky.get_warnings(), PackedStringArray())


func test_warnings_about_the_world() -> void:
	var viewport := _viewport()
	viewport.use_hdr_2d = true
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	viewport.add_child(world)
	_complete()
	viewport.add_child(_sky)
	assert_eq(_sky.get_warnings(), PackedStringArray())
	viewport.use_hdr_2d = false
	_expect_warning("HDR 2D", "hdr_2d")
	viewport.use_hdr_2d = true
	world.environment.tonemap_mode = Environment.TONE_MAPPER_ACES
	_expect_warning("tone mapper", "Linear")
	world.environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	world.environment.fog_enabled = true
	_expect_warning("fog", "Switch it off")
	world.environment.fog_enabled = false
	world.environment.background_mode = Environment.BG_SKY
	_expect_warning("sky of its own", "Custom Color")
	world.environment.background_mode = Environment.BG_COLOR
	_sky.scale = Vector3(2, 2, 2)
	_expect_warning("scaled", "schwarzschild_radius")


func test_the_scene_runs_with_nothing_given() -> void:
	var viewport := _viewport()
	viewport.add_child(_sky)
	for kind: BlackHoleSky.Background in [
		BlackHoleSky.BACKGROUND_NONE, BlackHoleSky.BACKGROUND_GRID, BlackHoleSky.BACKGROUND_PANORAMA
	]:
		_sky.background = kind
		await wait_process_frames(2)
	assert_eq(get_errors().size(), 0)


func test_the_scene_runs_with_damaged_files() -> void:
	var viewport := _viewport()
	viewport.add_child(_sky)
	_sky.table = LensingTable.new()
	_sky.table.load_file(_folder.write_text("broken.lut", "no table"))
	assert_push_error("broken.lut")
	_sky.catalogue = StarCatalogue.new()
	_sky.catalogue.load_file(_folder.write_text("broken.csv", "ra_deg,dec_deg,vmag\n1,2,nan\n"))
	assert_push_error("broken.csv")
	await wait_process_frames(2)
	_expect_warning("no lensing table", "source_file")
	_expect_warning("no stars", "source_file")


func test_a_table_that_arrives_later() -> void:
	var viewport := _viewport()
	_sky.table = LensingTable.new()
	viewport.add_child(_sky)
	await wait_process_frames(1)
	_sky.table.bake()
	assert_true(await wait_for_signal(_sky.table.bake_finished, 60.0))
	await wait_process_frames(1)
	for warning in _sky.get_warnings():
		assert_false(warning.contains("no lensing table"), warning)


func test_moving_between_worlds_and_leaving() -> void:
	_complete()
	var one := _viewport()
	var two := _viewport()
	one.add_child(_sky)
	await wait_process_frames(1)
	_sky.reparent(two)
	await wait_process_frames(1)
	two.remove_child(_sky)
	await wait_process_frames(1)
	one.add_child(_sky)
	one.add_child(Camera3D.new())
	await wait_process_frames(1)
	assert_gte(_sky.get_update_time_ms(), 0.0)


func test_many_nodes_come_and_go() -> void:
	var viewport := _viewport()
	for i in 20:
		var sky := BlackHoleSky.new()
		sky.table = LensingTable.new()
		sky.table.load_file(TABLE)
		sky.catalogue = StarCatalogue.new()
		sky.catalogue.set_stars([Vector3.UP], [1.0])
		viewport.add_child(sky)
		if i % 2 == 0:
			await wait_process_frames(1)
		sky.free()
	await wait_process_frames(1)
	assert_eq(viewport.get_child_count(), 1, "the camera alone")


func test_saved_and_loaded_with_its_scene() -> void:
	_sky.schwarzschild_radius = 3.0
	_sky.image_orders = 4
	_sky.psf_model = BlackHoleSky.PSF_EYE
	_sky.glare = 0.5
	_sky.table = LensingTable.new()
	_sky.table.source_file = TABLE
	var scene := PackedScene.new()
	assert_eq(scene.pack(_sky), OK)
	var path := _folder.file("sky.tscn")
	assert_eq(ResourceSaver.save(scene, path), OK)
	var loaded: BlackHoleSky = autofree((load(path) as PackedScene).instantiate())
	assert_eq(loaded.schwarzschild_radius, 3.0)
	assert_eq(loaded.image_orders, 4)
	assert_eq(loaded.psf_model, BlackHoleSky.PSF_EYE)
	assert_eq(loaded.glare, 0.5)
	assert_true(loaded.table.is_ready())


func _viewport() -> SubViewport:
	var viewport := SubViewport.new()
	viewport.own_world_3d = true
	viewport.add_child(Camera3D.new())
	return add_child_autofree(viewport)


func _complete() -> void:
	_sky.table = LensingTable.new()
	_sky.table.load_file(TABLE)
	_sky.catalogue = StarCatalogue.new()
	_sky.catalogue.set_stars([Vector3.UP, Vector3.LEFT], [1.0, 2.0])


func _expect_warning(problem: String, remedy: String) -> void:
	for warning in _sky.get_warnings():
		if warning.contains(problem):
			assert_string_contains(warning, remedy)
			return
	fail_test("no warning says '%s': %s" % [problem, _sky.get_warnings()])


## One solar mass: 2.953 km, 9.85 microseconds; the unit of acceleration is c^2 over that.
func test_units_of_a_mass() -> void:
	_sky.mass_solar = 1.0
	assert_almost_eq(_sky.get_length_unit_km(), 2.95325008, 1e-7)
	assert_almost_eq(_sky.get_time_unit_seconds(), 2953.25008 / 299792458.0, 1e-13)
	assert_almost_eq(_sky.get_acceleration_unit_g() / 1e12, 3.10333, 1e-4)
	_sky.mass_solar = 4.3e6
	assert_almost_eq(_sky.get_length_unit_km() / 4.3e6, 2.95325008, 1e-7)


func test_observer_is_made_when_its_motion_is_set() -> void:
	assert_null(_sky.observer)
	_sky.observer_motion = LensingTable.MOTION_ORBIT
	assert_eq(_sky.observer.motion, LensingTable.MOTION_ORBIT)
	_sky.observer = null
	assert_eq(_sky.observer_motion, LensingTable.MOTION_STATIC)


func test_says_where_there_is_no_such_observer() -> void:
	var sky: BlackHoleSky = add_child_autofree(BlackHoleSky.new())
	assert_eq(
		sky.get_observer_refusal_at(Vector3(0.1, 0, 0)), "", "without a hole nothing is refused"
	)
	sky.table = LensingTable.new()
	sky.table.load_file(TABLE)
	assert_string_contains(sky.get_observer_refusal_at(Vector3(0.5, 0, 0)), "horizon")
	assert_eq(sky.get_observer_refusal_at(Vector3(2.0, 0, 0)), "")
	sky.schwarzschild_radius = 4.0
	assert_string_contains(sky.get_observer_refusal_at(Vector3(2.0, 0, 0)), "horizon")
