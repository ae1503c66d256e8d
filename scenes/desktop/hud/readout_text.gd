# SPDX-License-Identifier: MIT
class_name ReadoutText
extends RefCounted
## Turns the values on the display into text.

const DIGITS: int = 4
const NOTHING: String = "–"


## A length in Schwarzschild radii, to four digits.
static func distance(schwarzschild_radii: float) -> String:
	return "%s rₛ" % significant(schwarzschild_radii)


## An angle, in degrees to four digits.
static func angle(radians: float) -> String:
	if not is_finite(radians):
		return NOTHING
	return "%s°" % significant(rad_to_deg(radians))


## An exposure with its sign.
static func exposure(ev: float) -> String:
	if is_zero_approx(ev):
		return "0 EV"
	return ("+%s EV" if ev > 0.0 else "−%s EV") % String.num(absf(ev), 1)


## A positive number to four significant digits, never in exponential form.
static func significant(value: float) -> String:
	if not is_finite(value):
		return NOTHING
	if is_zero_approx(value):
		return "0"
	var magnitude := floori(log(absf(value)) / log(10.0) + 1e-9)
	return "%.*f" % [clampi(DIGITS - 1 - magnitude, 0, 8), value]


## A number with no more digits than it has.
static func plain(value: float) -> String:
	return String.num(value, 6)


## A number of any size in four digits and a word: 354.4, 12.70 million.
static func counted(value: float) -> String:
	var size := absf(value)
	for word: Array in _large():
		var unit: float = word[0]
		if size >= unit:
			return "%s %s" % [significant(value / unit), word[1]]
	return significant(value)


## A length of so many Schwarzschild radii, each of `unit_km` kilometres.
static func kilometres(schwarzschild_radii: float, unit_km: float) -> String:
	return "%s km" % counted(schwarzschild_radii * unit_km)


## A time in seconds, in the unit in which it reads best.
static func duration(seconds: float) -> String:
	if not is_finite(seconds):
		return NOTHING
	for unit: Array in _times():
		var size: float = unit[0]
		if absf(seconds) >= size:
			return "%s %s" % [significant(seconds / size), unit[1]]
	return "%s ns" % significant(seconds / 1e-9) if seconds != 0.0 else "0 s"


## A time in light travel times of a Schwarzschild radius.
static func natural_time(time: float) -> String:
	return "%s rₛ/c" % significant(time)


## A speed in units of that of light.
static func speed(beta: float) -> String:
	if not is_finite(beta):
		return NOTHING
	return "%.4f c" % minf(beta, 0.9999) if beta < 0.9999 else "> 0.9999 c"


## How fast far clocks are seen to tick.
static func clock_rate(rate: float) -> String:
	return "× %s" % significant(rate) if is_finite(rate) else NOTHING


## An acceleration of so many c²/rₛ, each of `unit_g` standard gravities.
static func acceleration(value: float, unit_g: float) -> String:
	return "%s g" % counted(value * unit_g)


static func observer(motion: LensingTable.Motion) -> String:
	match motion:
		LensingTable.MOTION_STATIC:
			return _translated("static, hovering")
		LensingTable.MOTION_INFALL:
			return _translated("falling")
		LensingTable.MOTION_ORBIT:
			return _translated("circular orbit")
		LensingTable.MOTION_VELOCITY:
			return _translated("under way")
	return _translated("rain, falling from infinity")


static func background(kind: BlackHoleSky.Background) -> String:
	match kind:
		BlackHoleSky.BACKGROUND_GRID:
			return _translated("grid")
		BlackHoleSky.BACKGROUND_PANORAMA:
			return _translated("Milky Way")
	return _translated("no background")


static func image_orders(orders: int) -> String:
	if orders == 1:
		return _translated("1 image order")
	return _translated("%d image orders") % orders


static func _large() -> Array[Array]:
	return [
		[1e12, _translated("trillion")],
		[1e9, _translated("billion")],
		[1e6, _translated("million")],
	]


static func _times() -> Array[Array]:
	return [
		[31557600.0, _translated("years")],
		[86400.0, _translated("days")],
		[3600.0, _translated("hours")],
		[60.0, _translated("minutes")],
		[1.0, "s"],
		[1e-3, "ms"],
		[1e-6, "µs"],
	]


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
