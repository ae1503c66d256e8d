# SPDX-License-Identifier: MIT
class_name StarCsv
extends RefCounted
## Stars as the text of a .csv catalogue.


static func text(
	directions: PackedVector3Array, magnitudes: PackedFloat32Array, kelvins: PackedFloat32Array
) -> String:
	var lines: PackedStringArray = ["ra_deg,dec_deg,vmag,temperature_k"]
	for i in directions.size():
		var star := directions[i]
		var right_ascension := rad_to_deg(atan2(-star.z, star.x))
		var declination := rad_to_deg(atan2(star.y, Vector2(star.x, star.z).length()))
		lines.append(
			"%.9f,%.9f,%.6f,%.3f" % [right_ascension, declination, magnitudes[i], kelvins[i]]
		)
	return "\n".join(lines) + "\n"
