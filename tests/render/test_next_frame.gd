# SPDX-License-Identifier: MIT
extends GutTest
## Each property of the sky and of the disk that is changed shows in the very next frame.
##
## A property that is new to these classes must be listed here, with a value that shows.

const SIZE := Vector2i(160, 90)
const ORBIT := LensingTable.MOTION_ORBIT
const TURBULENT: Dictionary = {"look": AccretionDisk.LOOK_TURBULENT}
const CHECKERED: Dictionary = {"look": AccretionDisk.LOOK_CHECKERBOARD}
const RINGS: Dictionary = {"look": AccretionDisk.LOOK_RINGS, "ring_radii": [3.0, 5.0]}
const MOVING: Dictionary = {"observer_motion": ORBIT}
## Property: value, and what else must be set for it to matter (with a "disk", on the disk).
const SKY: Dictionary[String, Array] = {
	"schwarzschild_radius": [2.0],
	"mass_solar": [1e5, {"disk": {"accretion_rate": 1e-9}}],
	"lensing": [0.5],
	"observer": [null, MOVING],
	"observer_motion": [LensingTable.MOTION_RAIN],
	"table": [null],
	"catalogue": [null],
	"stars_visible": [false],
	"magnitude_limit": [0.0],
	"image_orders": [1],
	"psf_model": [BlackHoleSky.PSF_AIRY],
	"psf_sigma": [3.0],
	"aperture_mm": [0.3, {"psf_model": BlackHoleSky.PSF_AIRY}],
	"glare": [0.0, {"psf_model": BlackHoleSky.PSF_EYE}],
	"faint_limit": [0.01],
	"effect_deflection": [false],
	"effect_aberration": [false, MOVING],
	"effect_gravitational_shift": [false, MOVING],
	"effect_doppler": [false, MOVING],
	"effect_magnification": [false],
	"effect_higher_orders": [false],
	"overlays": [BlackHoleSky.OVERLAY_EINSTEIN_RINGS],
	"overlay_width": [5.0, {"overlays": BlackHoleSky.OVERLAY_EINSTEIN_RINGS}],
	"figure_field": [null, {"overlays": BlackHoleSky.OVERLAY_CONSTELLATIONS}],
	"projection": [BlackHoleSky.PROJECTION_MOLLWEIDE],
	"exposure": [4.0],
	"auto_exposure": [true],
	"saturation": [0.0],
	"see_through": [1.0],
	"redshift_map": [true],
	"background": [BlackHoleSky.BACKGROUND_GRID],
	"panorama": [null],
	"panorama_luminance": [1.0],
	"panorama_is_light": [false],
	"cubemap": [null, {"background": BlackHoleSky.BACKGROUND_CUBEMAP}],
	"render_layers": [2],
}
const DISK: Dictionary[String, Array] = {
	"outer_radius": [4.0],
	"outer_fade": [1.0],
	"retrograde": [true],
	"plunging_gas": [true],
	"plunging_temperature": [0.1, {"plunging_gas": true}],
	"peak_temperature": [3000.0],
	"accretion_rate": [1e-9],
	"brightness_ev": [-34.0],
	"opacity": [0.3],
	"limb_darkening": [true],
	"orders": [1],
	"look": [AccretionDisk.LOOK_CHECKERBOARD],
	"turbulence": [3.0, TURBULENT],
	"eddy_lifetime": [20.0, TURBULENT],
	"checker_sectors": [8, CHECKERED],
	"checker_ring_width": [2.0, CHECKERED],
	"ring_radii": [[4.0], RINGS],
	"ring_highlight": [1, RINGS],
	"ring_width": [5.0, RINGS],
	"time": [30.0, TURBULENT],
	"time_scale": [500.0, TURBULENT],
}
## Those that one picture cannot show, and where they are tested.
const ELSEWHERE: Dictionary[String, String] = {
	"adaptation_speed": "test_auto_exposure.gd: it takes time",
	"auto_exposure_min_ev": "test_auto_exposure.gd: the picture adapts meanwhile",
	"auto_exposure_max_ev": "test_auto_exposure.gd: the picture adapts meanwhile",
	"stereo_baseline_scale": "tests/xr: it takes two eyes",
}

var _booth: SkyBooth
var _disk := AccretionDisk.new()

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.add_child(_disk)
	add_child(_booth)
	_booth.viewport.size = SIZE
	_booth.camera.cull_mask = 1
	_booth.camera.look_at_from_position(Vector3(0, 2, 8), Vector3.ZERO)
	_booth.show_stars(_star_directions(), _numbers(400, 1.0, 5.0), _numbers(400, 3000.0, 9000.0))
	var sky := _booth.sky
	sky.image_orders = 2
	sky.magnitude_limit = 12.0
	sky.exposure = 2.0
	sky.panorama = load(MilkyWay.FILE)
	sky.panorama_luminance = MilkyWay.LUMINANCE
	sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	sky.figure_field = ConstellationOverlay.bake(ConstellationFigures.load_file())
	sky.cubemap = sky.figure_field
	_disk.brightness_ev = -36.0


func after_all() -> void:
	_booth.free()


func test_every_property_of_the_sky(property: Variant = use_parameters(SKY.keys())) -> void:
	_disk.visible = "disk" in _needs(SKY, property)
	await _expect_change(_booth.sky, SKY, property)


func test_every_property_of_the_disk(property: Variant = use_parameters(DISK.keys())) -> void:
	_disk.visible = true
	await _expect_change(_disk, DISK, property)


func test_no_property_is_left_out() -> void:
	for kind: String in ["BlackHoleSky", "AccretionDisk"]:
		var listed := SKY if kind == "BlackHoleSky" else DISK
		for property in ClassDB.class_get_property_list(kind, true):
			var is_shown: bool = property["usage"] & PROPERTY_USAGE_EDITOR
			var its_name: String = property["name"]
			if is_shown and not its_name in ELSEWHERE:
				assert_has(listed, its_name, kind)


func _expect_change(node: Node, table: Dictionary[String, Array], property: String) -> void:
	var undo: Array[Callable] = []
	var needs := _needs(table, property)
	for need: String in needs:
		if need != "disk":
			_change(node, need, needs[need], undo)
	for need: String in needs.get("disk", {}):
		_change(_disk, need, needs["disk"][need], undo)
	var first := await _booth.take()
	var before := await _booth.take()
	assert_true(first.get_data() == before.get_data(), "nothing else moves")
	_change(node, property, table[property][0], undo)
	var after := await _booth.take()
	assert_false(after.get_data() == before.get_data(), "%s shows" % property)
	undo.reverse()
	for step in undo:
		step.call()


func _change(node: Node, property: String, value: Variant, undo: Array[Callable]) -> void:
	undo.append(node.set.bind(property, node.get(property)))
	node.set(property, value)


func _needs(table: Dictionary[String, Array], property: String) -> Dictionary:
	return table[property][1] if table[property].size() > 1 else {}


func _star_directions() -> PackedVector3Array:
	var chance := RandomNumberGenerator.new()
	chance.seed = 1
	var directions := PackedVector3Array()
	for star in 400:
		directions.append(Vector3(chance.randfn(), chance.randfn(), chance.randfn()).normalized())
	return directions


func _numbers(count: int, from: float, to: float) -> PackedFloat32Array:
	var numbers := PackedFloat32Array()
	for i in count:
		numbers.append(lerpf(from, to, float(i) / count))
	return numbers
