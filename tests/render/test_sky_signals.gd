# SPDX-License-Identifier: MIT
extends GutTest
## The sky tells when a camera passes the horizon, and when observer or quality change.

var _booth: SkyBooth
var _crossings: Array[Array] = []

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_each() -> void:
	_booth = SkyBooth.new()
	_booth.viewport.size = Vector2i(64, 64)
	_booth.sky.schwarzschild_radius = 2.0
	_booth.sky.position = Vector3(1.0, 0.0, 0.0)
	add_child(_booth)
	_crossings.clear()
	_booth.sky.horizon_crossed.connect(_on_horizon_crossed)
	watch_signals(_booth.sky)


func after_each() -> void:
	_booth.free()


func test_each_passage_is_told_of_once() -> void:
	await _go([3.0, 1.2, 0.9, 0.5, 0.2])
	assert_eq(_crossings, [[true, _booth.camera]])
	await _go([0.9, 1.5])
	assert_eq(_crossings, [[true, _booth.camera], [false, _booth.camera]])
	await _go([0.1, 5.0])
	assert_eq(_crossings.size(), 4, "jumps count as well")


func test_one_who_trembles_at_the_horizon_passes_once() -> void:
	await _go([1.1, 1.0005, 0.9995, 1.0005, 0.9995, 0.998, 0.9995, 1.0005, 0.9995, 0.998])
	assert_eq(_crossings, [[true, _booth.camera]])


func test_another_camera_has_not_passed() -> void:
	await _go([3.0])
	var inside := Camera3D.new()
	inside.position = Vector3(1.5, 0.0, 0.0)
	_booth.viewport.add_child(inside)
	inside.make_current()
	await RenderingServer.frame_post_draw
	assert_eq(_crossings, [])
	inside.position.x = 9.0
	await RenderingServer.frame_post_draw
	assert_eq(_crossings, [[false, inside]])


func test_each_viewport_is_watched_if_it_sees_the_sky() -> void:
	var blind := _viewport(2)
	var seeing := _viewport(1)
	await _go([3.0])
	blind.position.x = 1.1
	seeing.position.x = 1.1
	await _go([3.0])
	assert_eq(_crossings, [[true, seeing]])


func test_without_a_hole_there_is_no_horizon() -> void:
	_booth.sky.lensing = 0.0
	await _go([3.0, 0.5, 3.0, 0.5])
	_booth.sky.lensing = 1.0
	await _go([0.5])
	assert_eq(_crossings, [])
	await _go([3.0])
	assert_eq(_crossings, [[false, _booth.camera]])


func test_who_hears_of_it_may_remove_the_sky() -> void:
	await _go([3.0])
	_booth.sky.horizon_crossed.connect(_on_crossed_remove)
	await _go([0.5])
	assert_false(_booth.sky.is_inside_tree())
	_booth.viewport.add_child(_booth.sky)
	await _go([3.0])
	assert_eq(_crossings.size(), 1, "it has not seen the way back")


func test_observers() -> void:
	var observer := SkyObserver.new()
	_booth.sky.observer = observer
	_booth.sky.observer = observer
	assert_signal_emit_count(_booth.sky, "observer_changed", 1)
	observer.motion = LensingTable.MOTION_RAIN
	observer.motion = LensingTable.MOTION_RAIN
	assert_signal_emit_count(_booth.sky, "observer_changed", 2)
	_booth.sky.observer_motion = LensingTable.MOTION_ORBIT
	assert_signal_emit_count(_booth.sky, "observer_changed", 3)
	_booth.sky.observer = null
	observer.energy = 1.5
	assert_signal_emit_count(_booth.sky, "observer_changed", 4, "the last one is left alone")


func test_quality() -> void:
	var sky := _booth.sky
	var changes: Dictionary[String, Variant] = {
		"image_orders": 1,
		"magnitude_limit": 6.0,
		"faint_limit": 1e-3,
		"psf_model": BlackHoleSky.PSF_EYE,
		"effect_higher_orders": false,
	}
	var told := 0
	for property in changes:
		sky.set(property, changes[property])
		sky.set(property, changes[property])
		told += 1
		assert_signal_emit_count(sky, "quality_changed", told, property)
	sky.exposure = 3.0
	assert_signal_emit_count(sky, "quality_changed", told, "exposure is no quality")


## Draws a frame at each of these r.
func _go(radii: PackedFloat64Array) -> void:
	for r in radii:
		_booth.camera.position = Vector3(1.0, 0.0, 2.0 * r)
		await RenderingServer.frame_post_draw


## A further picture of the same world; its camera.
func _viewport(cull_mask: int) -> Camera3D:
	var viewport := SubViewport.new()
	viewport.size = Vector2i(32, 32)
	var camera := Camera3D.new()
	camera.cull_mask = cull_mask
	camera.position.x = 9.0
	viewport.add_child(camera)
	_booth.viewport.add_child(viewport)
	return camera


func _on_horizon_crossed(inward: bool, camera: Camera3D) -> void:
	_crossings.append([inward, camera])


func _on_crossed_remove(_inward: bool, _camera: Camera3D) -> void:
	_booth.viewport.remove_child(_booth.sky)
