# SPDX-License-Identifier: MIT
class_name StarPlacesCheck
extends SelfCheck
## Are stars drawn where the exact solution has them, as bright as they must be, and nowhere else?

const PLACE := Vector3(4.8, -3.6, 8.0)
const MOST_PIXELS: float = 0.1
const MOST_LIGHT: float = 0.05
const SPRITE_RADIUS: int = 6

## What the sky is told of the observer; each is compared with the exact solution for `truths`.
var observers: Array[SkyObserver] = []
var truths: Array[SkyObserver] = []


func _init() -> void:
	name = &"star_places"
	compares = "place and light of stars drawn, direct and second images, with the exact solution"
	fault = "Stars are missing, in wrong places or of wrong brightness."
	remedy = FIRST_THINGS_FIRST + newer_driver_or_renderer()
	for motion: LensingTable.Motion in [LensingTable.MOTION_STATIC, LensingTable.MOTION_ORBIT]:
		var observer := SkyObserver.new()
		observer.motion = motion
		observers.append(observer)
		truths.append(observer.duplicate() as SkyObserver)


func measure(stage: SelfTestStage, result: CheckResult) -> void:
	stage.sky.lensing = 1.0
	stage.sky.background = BlackHoleSky.BACKGROUND_NONE
	stage.sky.image_orders = StarTargets.ORDERS
	for i in observers.size():
		stage.look_from(PLACE)
		stage.sky.observer = observers[i]
		var targets := StarTargets.new(stage, PLACE, truths[i])
		stage.sky.catalogue = targets.catalogue()
		var picture: Image = await stage.take()
		_compare(picture, targets, result)
		_search_the_shadow(stage, picture, truths[i], result)


func _compare(picture: Image, targets: StarTargets, result: CheckResult) -> void:
	var missing := 0
	for i in targets.pixels.size():
		var light := PicturePatch.light(picture, targets.pixels[i], SPRITE_RADIUS)
		if not light > 0.1 * StarTargets.LIGHT:
			missing += 1
			continue
		var off := PicturePatch.centroid(picture, targets.pixels[i]) - targets.pixels[i]
		result.compare("place", off.length(), MOST_PIXELS, "px")
		result.compare("light", light / StarTargets.LIGHT - 1.0, MOST_LIGHT)
	if missing > 0:
		result.object("%d of %d stars are not there." % [missing, targets.pixels.size()])
	result.compare("missing stars", missing, 0.0)


func _search_the_shadow(
	stage: SelfTestStage, picture: Image, observer: SkyObserver, result: CheckResult
) -> void:
	var shadow: Dictionary = observer.shadow(PLACE)
	var towards: Vector3 = shadow["direction"]
	var half_angle: float = shadow["half_angle"]
	var centre := stage.to_pixel(towards)
	# A square within the shadow that no sprite at its edge reaches into.
	var reach := floori((stage.focal() * tan(half_angle) - SPRITE_RADIUS) / sqrt(2.0)) - 1
	if PicturePatch.light(picture, centre, reach) > 0.0:
		result.object("There is light inside of the shadow.")
