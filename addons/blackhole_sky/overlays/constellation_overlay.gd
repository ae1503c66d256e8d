# SPDX-License-Identifier: MIT
class_name ConstellationOverlay
extends RefCounted
## Makes the cube map by which a BlackHoleSky draws the constellations' figures.

## Texels along a face's edge: lines are right to half a pixel of a picture of 720 rows.
const SIZE: int = 512


## The field of these figures; null, with an error, when it cannot be made. Takes a quarter of a
## second: to keep pictures coming, call [method bake_faces] on a worker thread instead.
static func bake(figures: ConstellationFigures, size: int = SIZE) -> Cubemap:
	return join_faces(bake_faces(figures, size))


## The six faces of the field; empty, with an error unless there are no figures, when it cannot be
## made. May be called on any thread.
static func bake_faces(figures: ConstellationFigures, size: int = SIZE) -> Array[Image]:
	var segments := PackedVector3Array()
	for figure in figures.figures:
		for line in figure.lines:
			for i in line.size() - 1:
				segments.append(line[i])
				segments.append(line[i + 1])
	return FigureField.bake(segments, size)


## The field with these faces, for [member BlackHoleSky.figure_field]; null when there are none.
static func join_faces(faces: Array[Image]) -> Cubemap:
	var field := Cubemap.new()
	if faces.is_empty() or field.create_from_images(faces) != OK:
		return null
	return field
