# SPDX-License-Identifier: MIT
extends XrTestCase
## Each eye sees the disk and the background bent for its own place, together and alone: edges on
## them stand in both pictures where the exact solution puts them for that eye, and nowhere else.
## Together only, unless everything is asked for.

const TOLERANCE_PX: float = 0.15
## The background's edge is one of a picture of limited sharpness.
const BACKGROUND_TOLERANCE_PX: float = 0.25
const RADIUS: float = 0.3
const INNER: float = 3.0
const OUTER: float = 6.0
const SECTORS: int = 14
## The background's edge passes so far beside the point behind the hole, radians.
const BESIDE: float = 0.3
const EYES := Vector3(0.2, 1.5, 0.3)

var _observer := SkyObserver.new()


func test_edges_in_both_eyes() -> void:
	if not await begun():
		return
	_set_up()
	await move_head(Transform3D(Basis(Vector3(0.2, 1.0, 0.3).normalized(), 0.12), EYES))
	_show_disk()
	if RendererScope.is_everything_wanted():
		_place_hole(6.0)
		await _expect("disk", [_disk_side])
	_show_background()
	_place_hole(8.0)
	await _expect("both", [_disk_side, _background_side])
	if not RendererScope.is_everything_wanted():
		return
	_get_disk().hide()
	_place_hole(7.0)
	await _expect("background", [_background_side])


func _expect(shown: String, measures: Array[Callable]) -> void:
	var pictures := await take_pictures()
	if pictures.size() < 2:
		return
	var eyes := eyes_of(pictures)
	for measure in measures:
		for view in 2:
			var what := "%s, %s, eye %d" % [shown, measure.get_method(), view]
			_expect_edges(pictures[view], eyes[view], eyes[1 - view].place, measure, what)


func _expect_edges(
	picture: Image, eye: EyeView, other: Vector3, measure: Callable, what: String
) -> void:
	var light := PictureMeasure.of_image(picture)
	var edges := EyeEdge.of_eye(eye, measure)
	var worst := 0.0
	var from_other := 0.0
	var from_middle := 0.0
	for edge in edges:
		var off := absf(edge.offset(light))
		worst = off if not off <= worst else worst
		from_other += edge.shift(eye, measure, other) / edges.size()
		from_middle += edge.shift(eye, measure, 0.5 * (eye.place + other)) / edges.size()
	gut.p(
		(
			"%s: %d places, worst %.3f px; the other eye's %.2f px away, the head's %.2f px"
			% [what, edges.size(), worst, from_other, from_middle]
		)
	)
	assert_gte(edges.size(), 8, "%s: places measured" % what)
	var of_disk := measure.get_method() == &"_disk_side"
	var tolerance := TOLERANCE_PX if of_disk else BACKGROUND_TOLERANCE_PX
	assert_lt(worst, tolerance, "%s: worst place" % what)
	# The test sees whose place it is: from another the edges would stand elsewhere.
	assert_gt(from_other, 8.0 * TOLERANCE_PX, "%s: other eye" % what)
	assert_gt(from_middle, 4.0 * TOLERANCE_PX, "%s: middle of the head" % what)


func _set_up() -> void:
	show_sky_alone()
	var sky := visit.scene.sky
	sky.stars_visible = false
	sky.background = BlackHoleSky.BACKGROUND_NONE
	sky.stereo_baseline_scale = 1.0
	sky.exposure = 0.0


## So many r_s away, and the sky so that its equator is the background's edge.
func _place_hole(distance: float) -> void:
	var sky := visit.scene.sky
	var ahead := Vector3(-0.1, 0.05, -1.0).normalized()
	sky.schwarzschild_radius = RADIUS
	sky.global_position = EYES + ahead * RADIUS * distance
	var across := ahead.cross(Vector3.UP).normalized().rotated(ahead, 0.5)
	var pole := across * cos(BESIDE) + ahead * sin(BESIDE)
	sky.global_basis = Basis(Quaternion(Vector3.UP, pole))
	_get_disk().global_basis = Basis(Vector3(1.0, 0.2, -0.3).normalized(), 0.6)


## A checkerboard that is looked at aslant.
func _show_disk() -> void:
	var disk := _get_disk()
	disk.look = AccretionDisk.LOOK_CHECKERBOARD
	disk.checker_ring_width = 1.0
	disk.checker_sectors = SECTORS
	disk.outer_radius = OUTER
	disk.outer_fade = 0.0
	disk.opacity = 1.0
	disk.plunging_gas = false
	disk.orders = 2
	disk.show()


## Northern sky white, southern black.
func _show_background() -> void:
	var image := Image.create(512, 256, false, Image.FORMAT_RGBF)
	image.fill_rect(Rect2i(0, 0, 512, 128), Color.WHITE)
	image.generate_mipmaps()
	var sky := visit.scene.sky
	sky.panorama = ImageTexture.create_from_image(image)
	sky.panorama_is_light = false
	sky.panorama_luminance = 0.8
	sky.background = BlackHoleSky.BACKGROUND_PANORAMA


## Positive on the bright fields of the disk, negative on the dark ones.
func _disk_side(place: Vector3, direction: Vector3) -> float:
	var disk := _get_disk()
	var point := _disk_point(place, direction, 0)
	var radius: float = point["radius"] if point["reached"] else 0.0
	if radius < INNER or radius > OUTER:
		return NAN
	var towards: Vector3 = point["place"]
	var seen: Vector3 = disk.basis.inverse() * towards
	var azimuth := atan2(-seen.z, seen.x)
	return sin(PI * (radius - INNER)) * sin(0.5 * SECTORS * azimuth)


## Positive on the northern sky, negative on the southern one.
func _background_side(place: Vector3, direction: Vector3) -> float:
	for order in 2 if _get_disk().visible else 0:
		var point := _disk_point(place, direction, order)
		if point["reached"] and point["radius"] > INNER - 0.1 and point["radius"] < OUTER + 0.1:
			return NAN
	var to_sky := visit.scene.sky.global_basis.inverse()
	var ray := _observer.trace(_from_hole(place), to_sky * direction)
	var seen: Vector3 = ray["sky_direction"]
	return NAN if ray["captured"] else seen.y


func _get_disk() -> AccretionDisk:
	return visit.scene.sky.get_node("Disk") as AccretionDisk


func _disk_point(place: Vector3, direction: Vector3, order: int) -> Dictionary:
	var sky := visit.scene.sky
	var disk := _get_disk()
	var to_sky := sky.global_basis.inverse()
	return _observer.disk_point(_from_hole(place), to_sky * direction, disk.basis.y, order)


## In the sky's axes, r_s.
func _from_hole(place: Vector3) -> Vector3:
	var sky := visit.scene.sky
	return sky.global_basis.inverse() * (place - sky.global_position) / sky.schwarzschild_radius
