# SPDX-License-Identifier: MIT
extends GutTest
## The corners of a checkerboard on the disk are where the exact solution has them: in the picture,
## and in one of the same few pixels that is drawn from the exact solution, point by point.

const RING: float = 3.0
## Of the exact pictures: half the side, and points per pixel and axis.
const HALF_PATCH: int = 7
const SAMPLES: int = 4
## Within which the finder looks, pixels.
const REACH: int = 4
const RADII: PackedFloat64Array = [6.0, 9.0, 12.0]
## Inclination in degrees, motion, radius in r_s, vertical field of view in degrees, sectors of the
## checkerboard, fewest corners.
const VIEWS: Array = [
	[5.0, LensingTable.MOTION_STATIC, 100.0, 16.0, 24, 48],
	[40.0, LensingTable.MOTION_RAIN, 30.0, 50.0, 24, 48],
	[60.0, LensingTable.MOTION_ORBIT, 4.0, 110.0, 24, 12],
	[75.0, LensingTable.MOTION_STATIC, 10.0, 90.0, 24, 20],
	[85.0, LensingTable.MOTION_ORBIT, 20.0, 50.0, 24, 10],
	[89.5, LensingTable.MOTION_RAIN, 20.0, 20.0, 48, 6],
]

var _booth: SkyBooth
var _disk := AccretionDisk.new()

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_disk.look = AccretionDisk.LOOK_CHECKERBOARD
	_disk.checker_ring_width = RING
	_disk.outer_radius = 15.0
	_disk.outer_fade = 0.0
	_disk.orders = 2
	_booth.sky.add_child(_disk)
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func test_corners(p: Array = use_parameters(RendererScope.fewer(VIEWS, 2))) -> void:
	var seen := DiskView.new(p[2], p[0], p[1], p[3])
	var sectors: int = p[4]
	_disk.basis = seen.disk_basis
	_disk.checker_sectors = sectors
	_booth.aim(seen.view)
	var finder := CornerFinder.of_picture(await _booth.take())
	var worst := 0.0
	var mean := Vector2.ZERO
	var corners := 0
	for order in 2:
		for radius in RADII:
			for sector in sectors:
				var place := _clear_corner(seen, radius, sector, sectors, order)
				var middle := Vector2.ONE * (HALF_PATCH + 0.5)
				var start := place.floor() - middle.floor()
				var expected := (
					_exact_patch(seen, start, sectors, order).near(place - start, REACH)
					if place != ExactView.NOWHERE
					else CornerFinder.NOWHERE
				)
				if expected == CornerFinder.NOWHERE:
					continue
				var found := finder.near(place, REACH) - start
				assert_true(found.is_finite(), "%s: a corner at %s" % [p, place])
				worst = maxf(worst, found.distance_to(expected))
				mean += found - expected
				corners += 1
	gut.p("%s: %d corners, worst %.3f px, mean %s px" % [p, corners, worst, mean / corners])
	assert_gte(corners, p[5], "%s: corners measured" % [p])
	assert_lt(worst, 0.5, "%s: corners against the exact places" % [p])
	assert_lt((mean / corners).length(), 0.1, "%s: their mean" % [p])


## What the exact solution shows in the pixels from `start` on.
func _exact_patch(seen: DiskView, start: Vector2, sectors: int, order: int) -> CornerFinder:
	var side := 2 * HALF_PATCH + 1
	var luminance := PackedFloat32Array()
	for y in side:
		for x in side:
			var light := 0.0
			for part in SAMPLES * SAMPLES:
				var offset := (
					Vector2(part % SAMPLES + 0.5, floori(float(part) / SAMPLES) + 0.5) / SAMPLES
				)
				var point := seen.point_at(start + Vector2(x, y) + offset, order)
				var ring := floori((point.x - 3.0) / RING)
				var sector := floori(point.y * sectors / TAU)
				light += posmod(ring + sector, 2)
			luminance.append(light)
	return CornerFinder.new(luminance, Vector2i(side, side))


## Where a corner is seen whose fields are wide enough for the finder and not behind the disk.
func _clear_corner(seen: DiskView, radius: float, sector: int, sectors: int, order: int) -> Vector2:
	var azimuth := TAU * sector / sectors
	var expected := seen.pixel_of(radius, azimuth, order)
	if expected == ExactView.NOWHERE or not seen.view.holds(expected, 16.0):
		return ExactView.NOWHERE
	if seen.crossing_sine(expected, order) < 0.6:
		return ExactView.NOWHERE  # edges that run side by side meet nowhere in particular
	for turn in 12:
		var beside := expected + Vector2.from_angle(TAU * turn / 12) * 8.0
		var point := seen.point_at(beside, order)
		if (
			absf(point.x - radius) > 0.6 * RING
			or absf(angle_difference(azimuth, point.y)) > 0.6 * TAU / sectors
		):
			return ExactView.NOWHERE
		for nearer in order:
			var before := seen.point_at(beside, nearer).x
			if before > 2.9 and before < 15.5:
				return ExactView.NOWHERE
	return expected
