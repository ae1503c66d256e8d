# SPDX-License-Identifier: MIT
class_name FaintLightCheck
extends SelfCheck
## Does faint light add up, so that neither faint stars are lost nor crowds of them?

const STARS: int = 20
## Summed luminance of each: its brightest pixel is seven steps of an 8-bit screen.
const LIGHT: float = 0.0126
const SPRITE_RADIUS: int = 6
const MOST_LIGHT: float = 0.05
## Where sRGB values are blended, the one star and each of the many may be half a step of seven off;
## cards that round up and down in turns were seen.
const MOST_VALUE: float = 0.16


func _init() -> void:
	name = &"faint_light"
	compares = "%d faint stars on one spot with %d times one of them" % [STARS, STARS]
	fault = "Faint light is cut off or rounded away before it adds up."
	remedy = (
		"Switch on rendering/viewport/hdr_2d (SubViewports: use_hdr_2d), keep the node's faint_limit low,"
		+ " and update the graphics driver."
	)


func measure(stage: SelfTestStage, result: CheckResult) -> void:
	stage.look_from(StarPlacesCheck.PLACE)
	stage.sky.background = BlackHoleSky.BACKGROUND_NONE
	stage.sky.lensing = 0.0
	# The middle of a pixel.
	var spot := 0.5 * Vector2(stage.viewport.size) + Vector2(20.5, 30.5)
	var one: Image = await _picture(stage, spot, 1)
	var many: Image = await _picture(stage, spot, STARS)
	stage.sky.lensing = 1.0
	if SelfTestStage.is_linear():
		_judge_linear(spot, one, many, result)
	else:
		var value := one.get_pixelv(Vector2i(spot)).g
		var sum := many.get_pixelv(Vector2i(spot)).g
		result.compare("value on the screen", _share(sum, value * STARS), MOST_VALUE)


func _judge_linear(spot: Vector2, one: Image, many: Image, result: CheckResult) -> void:
	if many.get_format() not in PictureMeasure.LINEAR_FORMATS:
		result.object("The picture is no HDR 2D buffer: hdr_2d is off, or the card lacks it.")
	for count: int in [1, STARS]:
		var light := PicturePatch.light(one if count == 1 else many, spot, SPRITE_RADIUS)
		var whose := "light of one star" if count == 1 else "light of %d stars" % count
		result.compare(whose, _share(light, LIGHT * count), MOST_LIGHT)


func _picture(stage: SelfTestStage, spot: Vector2, count: int) -> Image:
	var direction := stage.to_direction(spot)
	var magnitude := StarTargets.magnitude_of(LIGHT / StarTargets.flat_light(stage, spot))
	var directions: PackedVector3Array = []
	var magnitudes: PackedFloat32Array = []
	var kelvins: PackedFloat32Array = []
	for i in count:
		directions.append(direction)
		magnitudes.append(magnitude)
		kelvins.append(StarTargets.WHITE_KELVIN)
	stage.sky.catalogue = StarCatalogue.new()
	stage.sky.catalogue.set_stars(directions, magnitudes, kelvins)
	return await stage.take()


## How far a value is from the wanted one, as a part of that; without any light 1.
static func _share(value: float, wanted: float) -> float:
	return value / wanted - 1.0 if wanted > 0.0 else 1.0
