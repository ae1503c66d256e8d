# SPDX-License-Identifier: MIT
extends GutTest
## The magnification mu of a star's image and its frequency ratio g depend on how the observer
## moves, mu g^2 does not: it is the same for all observers at a place.
##
## Measured through the whole capture, from shot and catalogue to the .exr file read back: the
## summed luminance L of a lone star gives mu = L / (L0 Y(gT)/Y(T)), L0 being the star's without the
## hole; g is the exact solution's, and Y is summed from the CIE table. Of mu nothing is assumed.

const TOLERANCE: float = 0.01
const KELVIN: float = 6500.0
## Summed luminance of the star for the static observer.
const LIGHT: float = 5.0
const RADIUS_PX: int = 8
const SIZE := Vector2i(320, 240)

var _observers: Array = [
	"static",
	"rain",
	{"motion": "infall", "energy": 1.6},
	{"motion": "orbit", "axis": [0.2, 1.0, -0.1]},
	{"motion": "velocity", "celerity": [0.6, -0.9, 1.1]},
	{"motion": "velocity", "celerity": [-0.8, 0.3, 0.4], "relative_to": "static"},
]
var _stage: ShotStage
var _folder := ScratchFolder.new("equal_light")

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_each() -> void:
	# It keeps the catalogues that it has read.
	_stage = ShotStage.new()
	add_child_autofree(_stage)


func test_mu_g2_is_the_same_for_all_observers(
	# distance, order of the image
	p: Array = use_parameters([[6.0, 0], [6.0, 1], [3.0, 0], [3.0, 1]])
) -> void:
	if not SkyBooth.is_linear():
		pending("the Compatibility renderer has no linear light to write")
		return
	var distance: float = p[0]
	var order: int = p[1]
	var place := Vector3(0.6, 0.0, 0.8) * distance
	# Neither in the plane of the orbit nor in that of a velocity, and not behind the hole.
	var star := Vector3(-0.3, 0.8, -0.7).normalized()
	var still := ExactView.new(place, LensingTable.MOTION_STATIC).star_spot(star, order)
	var magnitude := _magnitude(still)
	_folder.write_text("star.csv", StarCsv.text([star], [magnitude], [KELVIN]))
	var products: PackedFloat64Array = []
	var ratios: PackedFloat64Array = []
	for observer: Variant in _observers:
		var g_and_mu := await _measure(place, star, order, magnitude, observer)
		ratios.append(g_and_mu.x)
		products.append(g_and_mu.y * g_and_mu.x * g_and_mu.x)
		gut.p("%s: g %.4f, mu %.5f, mu g^2 %.5f" % [observer, g_and_mu.x, g_and_mu.y, products[-1]])
	products.sort()
	ratios.sort()
	var spread := products[-1] / products[0] - 1.0
	gut.p("r = %s, order %d: mu g^2 differs by %.3f %%" % [distance, order, 100.0 * spread])
	assert_gt(products[0], 0.0, "light in every picture")
	assert_gt(ratios[-1] / ratios[0], 1.5, "shifts that differ")
	assert_lt(spread, TOLERANCE, "mu g^2, largest against smallest")


## g and the measured mu of an image.
func _measure(
	place: Vector3, star: Vector3, order: int, magnitude: float, motion: Variant
) -> Vector2:
	var observer := ShotObserver.from_data(motion, ExactView.doubled(place)).to_sky_observer()
	var exact: Dictionary = observer.star_image(place, star, order)
	var seen: Vector3 = exact["direction"]
	var g: float = exact["redshift"]
	var ahead := place + seen
	var shot := {
		"resolution": [SIZE.x, SIZE.y],
		"position_rs": [place.x, place.y, place.z],
		"look_at_rs": [ahead.x, ahead.y, ahead.z],
		"observer": motion,
		"stars":
		{"catalogue": _folder.file("star.csv"), "magnitude_limit": 99, "orders": order + 1},
	}
	var spec := ShotSpec.from_data(shot)
	assert_eq(spec.error, "", "the shot is fine")
	var refusal: PackedStringArray = []
	var picture: Image = await _stage.take(spec, refusal)
	assert_eq(refusal, PackedStringArray(), "the shot is taken")
	assert_eq(picture.save_exr(_folder.file("star.exr")), OK)
	var read := Image.load_from_file(_folder.file("star.exr"))
	var view := ExactView.new(place, LensingTable.MOTION_STATIC)
	view.size = SIZE
	var middle := 0.5 * Vector2(SIZE)
	var light := PicturePatch.light(read, middle, RADIUS_PX)
	var flat := view.flat_luminance_sum(middle) * pow(10.0, -0.4 * magnitude)
	return Vector2(g, light / (flat * PlanckLight.shift_factor(KELVIN, g)))


## The magnitude with which the static observer sees LIGHT.
func _magnitude(still: ExactView.StarSpot) -> float:
	var view := ExactView.new(Vector3(0, 0, 6), LensingTable.MOTION_STATIC)
	view.size = SIZE
	var factor := still.magnification * PlanckLight.shift_factor(KELVIN, still.redshift)
	var flux := LIGHT / (view.flat_luminance_sum(0.5 * Vector2(SIZE)) * factor)
	# As the catalogue writes it.
	return snappedf(-2.5 * log(flux) / log(10.0), 1e-6)
