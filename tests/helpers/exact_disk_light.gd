# SPDX-License-Identifier: MIT
class_name ExactDiskLight
extends RefCounted
## Luminance of an opaque black-body disk on the picture from the exact solution, on the radiometric
## scale of the stars: the Sun's surface has the light of the star that it is.

const SOLAR_MAGNITUDE: float = -26.74
const SOLAR_TEMPERATURE: float = 5772.0
const SOLAR_ANGULAR_RADIUS: float = 4.6505e-3
## Points of a pixel and axis that are averaged.
const SAMPLES: int = 2
const STEPS_PER_OCTAVE: float = 64.0

var outer_radius: float = 15.0
var peak_temperature: float = 6500.0
var orders: int = 3

var _logarithms: Dictionary[int, float] = {}


## Mean luminance of a pixel at exposure 0.
func of_pixel(seen: DiskView, pixel: Vector2i) -> float:
	var sum := 0.0
	for part in SAMPLES * SAMPLES:
		var offset := Vector2(part % SAMPLES + 0.5, floori(float(part) / SAMPLES) + 0.5) / SAMPLES
		sum += at(seen, Vector2(pixel) + offset)
	return sum / (SAMPLES * SAMPLES)


## Luminance at a place of the picture.
func at(seen: DiskView, place: Vector2) -> float:
	for order in orders:
		var point := seen.seen_at(place, order)
		if not point["reached"]:
			return 0.0
		var radius: float = point["radius"]
		if radius >= 3.0 and radius <= outer_radius:
			var redshift: float = point["redshift"]
			var kelvin := peak_temperature * AccretionDisk.page_thorne_temperature(radius)
			return of_black_body(kelvin * redshift)
	return 0.0


## Luminance of a black body's surface.
func of_black_body(kelvin: float) -> float:
	if kelvin < 100.0:
		return 0.0
	var place := log(kelvin) / log(2.0) * STEPS_PER_OCTAVE
	var lower := floori(place)
	return exp(lerpf(_logarithm(lower), _logarithm(lower + 1), place - lower))


func _logarithm(step: int) -> float:
	if not _logarithms.has(step):
		var solar := PlanckLight.luminance(SOLAR_TEMPERATURE)
		var star := ExactView.STAR_GAIN / pow(ExactView.REFERENCE_FOCAL_PX, 2)
		var sun := star * pow(10.0, -0.4 * SOLAR_MAGNITUDE) / (PI * pow(SOLAR_ANGULAR_RADIUS, 2))
		_logarithms[step] = log(
			sun * PlanckLight.luminance(pow(2.0, step / STEPS_PER_OCTAVE)) / solar
		)
	return _logarithms[step]
