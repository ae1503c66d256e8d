# SPDX-License-Identifier: MIT
class_name PlanckLight
extends RefCounted
## Luminance and colour of black bodies, summed directly from the CIE 1931 table: what the shaders'
## own table is measured against.

const TABLE_FILE: String = "res://tests/data/cie1931_2deg_1nm.csv"
## Second radiation constant h c / k in metre kelvin.
const SECOND_RADIATION: float = 1.438776877e-2
## Every fifth nanometre is enough: the sums change by less than 1e-5.
const STEP_NM: int = 5

static var _wavelengths: PackedFloat64Array = []
static var _weights: PackedFloat64Array = []
static var _x_weights: PackedFloat64Array = []
static var _z_weights: PackedFloat64Array = []


## Y(g T) / Y(T): by how much a black body's surface is brighter to the eye when all its frequencies
## are multiplied by g.
static func shift_factor(kelvin: float, g: float) -> float:
	return luminance(g * kelvin) / luminance(kelvin)


## CIE-weighted Planck integral at a temperature, in arbitrary units.
static func luminance(kelvin: float) -> float:
	_load()
	return _sum(_weights, kelvin)


## Linear Rec.709 colour of luminance 1 of a black body; channels may be negative below 1900 K.
static func colour(kelvin: float) -> Vector3:
	_load()
	var y := _sum(_weights, kelvin)
	var x := _sum(_x_weights, kelvin) / y
	var z := _sum(_z_weights, kelvin) / y
	return Vector3(
		3.2404542 * x - 1.5371385 - 0.4985314 * z,
		-0.9692660 * x + 1.8760108 + 0.0415560 * z,
		0.0556434 * x - 0.2040259 + 1.0572252 * z
	)


static func _sum(weights: PackedFloat64Array, kelvin: float) -> float:
	var total := 0.0
	for i in _wavelengths.size():
		var x := SECOND_RADIATION / (_wavelengths[i] * kelvin)
		# exp(x) - 1 for small x, where the difference would cancel: temperatures beyond 1e7 K.
		var denominator := exp(x) - 1.0 if x > 1e-5 else x * (1.0 + 0.5 * x)
		total += weights[i] / denominator
	return total


static func _load() -> void:
	if not _wavelengths.is_empty():
		return
	for line in FileAccess.get_file_as_string(TABLE_FILE).split("\n", false):
		var fields := line.split(",")
		if not fields[0].is_valid_float():
			continue
		if fields[0].to_int() % STEP_NM != 0:
			continue
		var wavelength := fields[0].to_float() * 1e-9
		_wavelengths.append(wavelength)
		var scale := pow(wavelength * 1e6, -5)
		_x_weights.append(fields[1].to_float() * scale)
		_weights.append(fields[2].to_float() * scale)
		_z_weights.append(fields[3].to_float() * scale)
