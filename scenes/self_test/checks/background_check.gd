# SPDX-License-Identifier: MIT
class_name BackgroundCheck
extends SelfCheck
## Is the background bent right: the shadow's edge, and on each side of the ring the right sky?

const MOST_PIXELS: float = 0.2
const RAYS: int = 90
## Every so many pixels the sky is looked at.
const STEP: int = 12
## Sine of the angle to the nearest boundary of colours that is left out.
const MARGIN: float = 0.25
## Pixels round the edge left out: there the whole sky crowds.
const EDGE: float = 12.0

## The other half of the sky, in sRGB.
const DIM: float = 0.5

## What the sky is told of the observer, and the one it is compared with.
var observer := SkyObserver.new()
var truth := SkyObserver.new()
## Each octant of the sky in a colour of its own, and for the shadow's edge a sky without colours.
var panorama := panorama_of(_octant_colour)
var white := panorama_of(_white)


func _init() -> void:
	name = &"background"
	compares = "the shadow's edge, and which octant of the sky is seen inside and outside of the ring"
	fault = "The background is bent wrongly: shadow, ring or the sky beside them are out of place."
	remedy = FIRST_THINGS_FIRST + newer_driver_or_renderer()


func measure(stage: SelfTestStage, result: CheckResult) -> void:
	var sky := stage.sky
	stage.look_from(StarPlacesCheck.PLACE)
	sky.lensing = 1.0
	sky.observer = observer
	sky.catalogue = null
	sky.panorama_luminance = 1.0
	sky.panorama_is_light = false
	sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	sky.panorama = white
	_measure_edge(stage, await stage.take(), result)
	sky.panorama = panorama
	_look_at_the_sky(stage, await stage.take(), result)
	sky.background = BlackHoleSky.BACKGROUND_NONE


## An equirectangular sky whose colours are a function of direction.
static func panorama_of(colour: Callable) -> ImageTexture:
	var image := Image.create_empty(256, 128, false, Image.FORMAT_RGB8)
	for y in 128:
		for x in 256:
			var seen: Color = colour.call(_sky_direction((x + 0.5) / 256.0, (y + 0.5) / 128.0))
			image.set_pixel(x, y, seen)
	image.generate_mipmaps()
	return ImageTexture.create_from_image(image)


## The direction at (u, v) of a panorama (BlackHoleSky.panorama).
static func _sky_direction(u: float, v: float) -> Vector3:
	var right_ascension := TAU * (0.25 - u)
	var declination := PI * (0.5 - v)
	var across := cos(declination)
	return Vector3(across * cos(right_ascension), sin(declination), -across * sin(right_ascension))


## Red, green and blue are full where x, y and z are positive.
static func _octant_colour(direction: Vector3) -> Color:
	return Color(
		1.0 if direction.x > 0.0 else DIM,
		1.0 if direction.y > 0.0 else DIM,
		1.0 if direction.z > 0.0 else DIM
	)


static func _white(_direction: Vector3) -> Color:
	return Color.WHITE


func _measure_edge(stage: SelfTestStage, picture: Image, result: CheckResult) -> void:
	var centre := 0.5 * Vector2(picture.get_size())
	var shadow: Dictionary = truth.shadow(StarPlacesCheck.PLACE)
	var half_angle: float = shadow["half_angle"]
	var radius := stage.focal() * tan(half_angle)
	var measured := PictureMeasure.of_image(picture)
	var points := measured.edge_points(centre, radius - 4.0, radius + 4.0, RAYS)
	if points.size() < RAYS:
		result.object("The shadow has no edge where it should be.")
	for point in points:
		result.compare("shadow's edge", point.distance_to(centre) - radius, MOST_PIXELS, "px")


func _look_at_the_sky(stage: SelfTestStage, picture: Image, result: CheckResult) -> void:
	var centre := 0.5 * Vector2(picture.get_size())
	var shadow: Dictionary = truth.shadow(StarPlacesCheck.PLACE)
	var half_angle: float = shadow["half_angle"]
	var radius := stage.focal() * tan(half_angle)
	var wrong := 0
	for y in range(STEP, picture.get_height(), STEP):
		for x in range(STEP, picture.get_width(), STEP):
			var pixel := Vector2(x + 0.5, y + 0.5)
			if absf(pixel.distance_to(centre) - radius) < EDGE:
				continue
			if not _is_right(stage, picture, pixel):
				wrong += 1
	result.compare("pixels that show another part of the sky", wrong, 0.0)


func _is_right(stage: SelfTestStage, picture: Image, pixel: Vector2) -> bool:
	var ray: Dictionary = truth.trace(StarPlacesCheck.PLACE, stage.to_direction(pixel))
	var seen := picture.get_pixelv(Vector2i(pixel))
	if picture.get_format() in PictureMeasure.LINEAR_FORMATS:
		seen = seen.linear_to_srgb()
	if ray["captured"]:
		return maxf(seen.r, maxf(seen.g, seen.b)) < 0.01
	var direction: Vector3 = ray["sky_direction"]
	if direction.abs()[direction.abs().min_axis_index()] < MARGIN:
		return true
	var wanted := _octant_colour(direction)
	var most := 0.5 * (1.0 - DIM)
	return (
		absf(seen.r - wanted.r) < most
		and absf(seen.g - wanted.g) < most
		and absf(seen.b - wanted.b) < most
	)
