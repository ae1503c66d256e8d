# SPDX-License-Identifier: MIT
class_name ConstellationOverlay
extends RefCounted
## Makes the cube map by which a BlackHoleSky draws the constellations' figures.

## Texels along a face's edge: lines are right to half a pixel of a picture of 720 rows.
const SIZE: int = 512


## The field of these figures; null, with an error, when it cannot be made. Takes a quarter of a
## second: call it on a worker thread while pictures are shown.
static func bake(figures: ConstellationFigures, size: int = SIZE) -> Cubemap:
	var segments := PackedVector3Array()
	for figure in figures.figures:
		for line in figure.lines:
			for i in line.size() - 1:
				segments.append(line[i])
				segments.append(line[i + 1])
	var faces := FigureField.bake(segments, size)
	if faces.is_empty():
		return null
	var field := Cubemap.new()
	if field.create_from_images(faces) != OK:
		return null
	return field
