# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## The map beside the picture: what it shares with the picture, and what is done from it.

var _map: MapWindow
var _view: MapView
var _camera: Camera3D
var _map_camera: Camera3D


func before_each() -> void:
	super()
	_map = _scene.get_node("%Map")
	_view = _map.get_node("%MapView")
	_camera = _scene.get_node("Camera")
	_map_camera = _map.get_node("%MapCamera")


func _open() -> void:
	_map.open()
	await wait_process_frames(2)


# Where the hole is in the first picture, as a share of the window.
func _hole_place() -> Vector2:
	var extent := _camera.get_viewport().get_visible_rect().size
	return _camera.unproject_position(_sky.global_position) / extent


func _direction_to_hole() -> Vector3:
	return _map_camera.global_position.direction_to(_sky.global_position)


func test_the_key_opens_and_closes_and_moves_the_picture_aside() -> void:
	assert_almost_eq(_hole_place(), Vector2(0.5, 0.5), Vector2.ONE * 1e-3)
	_press(_key_event(KEY_M))
	await wait_process_frames(2)
	assert_true(_map.visible)
	assert_almost_eq(_hole_place(), Vector2(0.25, 0.5), Vector2.ONE * 1e-3)
	var extent := Vector2(_scene.get_viewport().get_visible_rect().size)
	assert_almost_eq(_map.get_global_rect().position.x, 0.5 * extent.x, 1.0)
	_press(_key_event(KEY_M))
	await wait_process_frames(2)
	assert_false(_map.visible)
	assert_null(_view.get_map_sky())
	assert_almost_eq(_hole_place(), Vector2(0.5, 0.5), Vector2.ONE * 1e-3)


func test_each_camera_sees_its_own_sky() -> void:
	await _open()
	var second := _view.get_map_sky()
	assert_ne(second, _sky)
	assert_eq(_camera.cull_mask & second.render_layers, 0)
	assert_eq(_map_camera.cull_mask & _sky.render_layers, 0)
	assert_ne(_camera.cull_mask & _sky.render_layers, 0)
	assert_ne(_map_camera.cull_mask & second.render_layers, 0)
	assert_eq(_map_camera.get_world_3d(), _camera.get_world_3d())
	assert_true((_map.get_node("%MapViewport") as SubViewport).use_hdr_2d)


func test_the_map_follows_the_picture() -> void:
	await _open()
	var second := _view.get_map_sky()
	assert_eq(second.projection, BlackHoleSky.PROJECTION_MOLLWEIDE)
	_sky.observer_motion = LensingTable.MOTION_RAIN
	_sky.lensing = 0.7
	_sky.effect_doppler = false
	_sky.image_orders = 3
	_sky.overlays = BlackHoleSky.OVERLAY_GALACTIC_GRID
	_sky.redshift_map = true
	_sky.schwarzschild_radius = 2.0
	_let_pass(0.1)
	await wait_process_frames(2)
	assert_not_null(second.table)
	for property: StringName in [
		&"table",
		&"catalogue",
		&"panorama",
		&"background",
		&"observer",
		&"lensing",
		&"effect_doppler",
		&"image_orders",
		&"overlays",
		&"redshift_map",
		&"schwarzschild_radius",
	]:
		assert_eq(second.get(property), _sky.get(property), property)
	assert_almost_eq(
		_map_camera.global_position, _camera.global_position, Vector3.ONE * 1e-3, "one eye"
	)


func test_the_maps_middle_is_the_hole_wherever_one_looks() -> void:
	await _open()
	_controls.mode = ViewControls.Mode.FLIGHT
	_controls.rig.turn(1.0, 0.3, 0.2)
	await wait_process_frames(2)
	var axis := -_map_camera.global_basis.z
	assert_almost_eq(axis, _direction_to_hole(), Vector3.ONE * 1e-5)


func test_dragging_moves_the_stars_along() -> void:
	await _open()
	# A test's window may be too small for a map.
	_view.set_anchors_and_offsets_preset(Control.PRESET_TOP_LEFT)
	_view.size = Vector2(640.0, 400.0)
	_sky.lensing = 0.0
	_view.follow()
	# Half way between the middle and the left end, seen without the hole.
	var star := _map_camera.global_basis * Vector3(-1.0, 0.0, -1.0).normalized()
	var before := _view.get_map_sky().project_image(_map_camera, star)
	_view.turn_sky(Vector2(0.25, 0.0))
	_let_pass(1.0)
	_view.follow()
	var after := _view.get_map_sky().project_image(_map_camera, star)
	# Mollweide's equator is evenly divided over the whole width.
	var width := _map_camera.get_viewport().get_visible_rect().size.x
	assert_gt(width, 400.0)
	assert_almost_eq(after.x - before.x, width * 0.25 / TAU, 0.5)
	assert_almost_eq(after.y, before.y, 0.5)
	assert_almost_eq(_controls.rig.get_distance(), StartView.DISTANCE, 1e-3)
	var middle := _map_camera.global_basis * Vector3(0.05, 0.0, -1.0).normalized()
	before = _view.get_map_sky().project_image(_map_camera, middle)
	_view.turn_sky(Vector2(0.0, 0.2))
	_let_pass(1.0)
	_view.follow()
	after = _view.get_map_sky().project_image(_map_camera, middle)
	assert_gt(after.y, before.y, "down")


func test_the_radius_slider_goes_through_the_horizon() -> void:
	await _open()
	var radius: RideTrack = _map.get_node("%Radius")
	assert_almost_eq(MapWindow.radius_at(radius.value), StartView.DISTANCE, 0.01)
	assert_almost_eq(MapWindow.radius_at(radius.mark), 1.0, 1e-6, "the mark")
	for share: float in [0.0, 0.2, radius.mark, 0.7, 1.0]:
		radius.value = share
		assert_almost_eq(
			_controls.rig.get_distance() / MapWindow.radius_at(share), 1.0, 1e-4, str(share)
		)
	assert_lt(MapWindow.radius_at(0.0), 1.0)


func test_observer_and_map_are_chosen_beside_it() -> void:
	await _open()
	var observer: Stepper = _map.get_node("%MapObserver")
	assert_eq(observer.at, ObserverKind.Kind.STATIC)
	observer.chosen.emit(ObserverKind.Kind.RAIN)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_RAIN)
	assert_eq(observer.at, ObserverKind.Kind.RAIN)
	var projection: Stepper = _map.get_node("%MapProjection")
	projection.chosen.emit(0)
	await wait_process_frames(2)
	assert_eq(_view.get_map_sky().projection, BlackHoleSky.PROJECTION_EQUIRECTANGULAR)
	assert_eq(_sky.projection, BlackHoleSky.PROJECTION_PERSPECTIVE)


func test_the_panel_opens_and_closes_it() -> void:
	var panel: SkyPanel = _scene.get_node("%Panel")
	panel.toggle()
	var beside: Stepper = panel.get_node("%MapBeside")
	assert_eq(beside.at, BlackHoleSky.PROJECTION_PERSPECTIVE)
	beside.chosen.emit(BlackHoleSky.PROJECTION_FISHEYE_180)
	assert_true(_map.visible)
	assert_eq(_view.get_map_sky().projection, BlackHoleSky.PROJECTION_FISHEYE_180)
	panel.refresh()
	assert_eq(beside.at, BlackHoleSky.PROJECTION_FISHEYE_180)
	beside.chosen.emit(BlackHoleSky.PROJECTION_PERSPECTIVE)
	assert_false(_map.visible)


func test_a_map_in_the_first_picture_makes_room_and_comes_back() -> void:
	_sky.projection = BlackHoleSky.PROJECTION_MERCATOR
	_map.open()
	assert_eq(_sky.projection, BlackHoleSky.PROJECTION_PERSPECTIVE)
	_map.close()
	assert_eq(_sky.projection, BlackHoleSky.PROJECTION_MERCATOR)


func test_a_ride_keeps_its_own_way() -> void:
	var rides: RideDirector = _scene.get_node("Rides")
	rides.set_process(false)
	await _open()
	assert_true(rides.start(RideDirector.Kind.values()[0]))
	_map.refresh()
	assert_false((_map.get_node("%MapControls") as Control).visible)
	var place := _controls.rig.get_position()
	_view.turn_sky(Vector2(0.5, 0.5))
	_let_pass(1.0)
	assert_almost_eq(_controls.rig.get_position(), place, Vector3.ONE * 1e-5)
