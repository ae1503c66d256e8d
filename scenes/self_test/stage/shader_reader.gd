# SPDX-License-Identifier: MIT
class_name ShaderReader
extends Node
## Runs a canvas shader and reads the 32-bit floats it answers with, bit by bit, in every renderer:
## a float is a pixel of four bytes (see answer.gdshaderinc).

var _viewport := SubViewport.new()
var _picture := MeshInstance2D.new()


func _init() -> void:
	_viewport.disable_3d = true
	_viewport.use_hdr_2d = false
	# With an alpha channel the picture has eight bits a channel in Compatibility too.
	_viewport.transparent_bg = true
	_viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	_viewport.add_child(_picture)
	add_child(_viewport)


## The answers, `rows` rows of `columns` floats. The shader finds its row in UV.x of the vertices
## and in the whole part of VERTEX.y, its column in that of VERTEX.x.
func read(material: ShaderMaterial, columns: int, rows: int) -> PackedFloat32Array:
	_picture.mesh = _strips(columns, rows)
	_picture.material = material
	_viewport.size = Vector2i(columns, rows)
	for frame in SelfTestStage.WARM_UP_FRAMES:
		_viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
		await RenderingServer.frame_post_draw
	var picture := _viewport.get_texture().get_image()
	picture.convert(Image.FORMAT_RGBA8)
	# Viewports are two pixels high and wide at least.
	return picture.get_data().to_float32_array().slice(0, columns * rows)


## A strip one pixel high for each row.
func _strips(columns: int, rows: int) -> ArrayMesh:
	var vertices: PackedVector2Array = []
	var numbers: PackedVector2Array = []
	for row in rows:
		for corner: Vector2 in [
			Vector2(0, 0), Vector2(1, 0), Vector2(1, 1), Vector2(0, 0), Vector2(1, 1), Vector2(0, 1)
		]:
			vertices.append(Vector2(columns * corner.x, row + corner.y))
			numbers.append(Vector2(row, 0))
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = vertices
	arrays[Mesh.ARRAY_TEX_UV] = numbers
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh
