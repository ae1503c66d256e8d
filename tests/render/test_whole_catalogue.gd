# SPDX-License-Identifier: MIT
extends GutTest
## The real sky: no image of a catalogue star that is bright enough to be seen is left out.
##
## Stars are drawn in groups, of which the parts that can be seen are drawn: this looks for all
## images of a sample of stars from each group.

const MAGNITUDE_LIMIT: float = 8.0
## One star in so many is looked for.
const STEP: int = 7
## Images of higher orders must be so much brighter than the faint limit to be drawn: still within
## the first step of an 8-bit picture.
const HIGHER_ORDERS: float = 8.0

var _booth: SkyBooth
var _observers: Array = [
	[LensingTable.MOTION_STATIC, 1.3, 60.0],
	[LensingTable.MOTION_STATIC, 4.0, 60.0],
	[LensingTable.MOTION_STATIC, 200.0, 10.0],
	[LensingTable.MOTION_RAIN, 0.7, 60.0],
]


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.catalogue = StarCatalogue.new()
	_booth.sky.catalogue.load_file(SkyBooth.CATALOGUE_FILE)
	_booth.sky.magnitude_limit = MAGNITUDE_LIMIT
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func test_every_image_is_there(p: Array = use_parameters(_observers)) -> void:
	var r: float = p[1]
	var view := ExactView.new(Vector3(0.36, -0.48, 0.8) * r, p[0])
	view.vertical_fov_deg = p[2]
	view.look_beside(view.shadow_half_angle() + deg_to_rad(0.2 * view.vertical_fov_deg), Vector3.UP)
	_booth.aim(view)
	var measure := PictureMeasure.of_image(await _booth.take())
	# Fainter peaks are not drawn, or lost in the first step of an 8-bit picture.
	var faintest := 1.1 * _booth.sky.faint_limit if SkyBooth.is_linear() else 1e-3
	var stars := _booth.sky.catalogue
	var found: PackedInt32Array = [0, 0, 0, 0]
	var missing := PackedStringArray()
	for i in range(0, stars.count_to_magnitude(MAGNITUDE_LIMIT), STEP):
		var flux := pow(10.0, -0.4 * stars.get_star_magnitude(i))
		for order in 4:
			var spot := view.star_spot(stars.get_star_direction(i), order)
			if spot.pixel == ExactView.NOWHERE or not view.holds(spot.pixel, 5.0):
				continue
			var light := flux * view.luminance_sum(spot, stars.get_star_temperature(i))
			var peak := light / TAU
			if peak < faintest * (HIGHER_ORDERS if order > 0 else 1.0):
				continue
			var seen := measure.at(floori(spot.pixel.x), floori(spot.pixel.y))
			# The pixel's centre may lie 0.7 px beside the image: exp(-1/4) of the peak.
			if seen < 0.7 * minf(peak, 1.0):
				missing.append("HIP %d order %d" % [stars.get_star_hip(i), order])
			found[order] += 1
	gut.p("%s images of each order" % found)
	assert_gt(found[0] + found[1], 50)
	assert_eq(missing, PackedStringArray(), "images that are missing")
