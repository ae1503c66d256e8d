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


static func observer(motion: LensingTable.Motion) -> String:
	if motion == LensingTable.MOTION_STATIC:
		return _translated("static, hovering")
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


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
