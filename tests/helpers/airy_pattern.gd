# SPDX-License-Identifier: MIT
class_name AiryPattern
extends RefCounted
## Diffraction by a circular aperture: what render tests hold pictures against.

## Dominant wavelengths of the Rec. 709 primaries, metres.
const WAVELENGTHS: PackedFloat64Array = [611.4e-9, 549.1e-9, 464.3e-9]
## First zero of J1: the radius of the first dark ring in the pattern's scale.
const FIRST_ZERO: float = 3.8317060
## First bright ring: its radius and brightness against the centre.
const FIRST_RING: float = 5.1356223
const RING_BRIGHTNESS: float = 0.0174978


## The pattern's scale in radians for channel 0, 1, 2.
static func scale(channel: int, aperture_mm: float) -> float:
	return WAVELENGTHS[channel] / (PI * aperture_mm * 1e-3)


## Light against the centre's: (2 J1(x)/x)^2, x below 20.
static func brightness(x: float) -> float:
	var term := 1.0
	var sum := 1.0
	for k in range(1, 60):
		term *= -0.25 * x * x / (k * (k + 1))
		sum += term
	return sum * sum
