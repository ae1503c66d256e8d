# SPDX-License-Identifier: MIT
extends Node3D
## An everyday room bent by a small black hole above its table. Left and right, up and down go round
## the hole, page up and down go nearer and farther; left alone, the camera goes round slowly.

const TURN: float = 0.8
const DRIFT: float = 0.06
const BOOKS_PER_SHELF: int = 52
const HUES: PackedFloat32Array = [0.05, 0.09, 0.2, 0.5, 0.65]

@onready var _arm: Node3D = $Arm
@onready var _camera: Camera3D = $Arm/Camera
@onready var _mobile: Node3D = $Room/Mobile


func _ready() -> void:
	($Room/Shelf/Books as MultiMeshInstance3D).multimesh = _books()


func _process(delta: float) -> void:
	_mobile.rotate_y(0.4 * delta)
	var aside := Input.get_axis(&"ui_left", &"ui_right")
	_arm.rotation.y += delta * (TURN * aside if aside != 0.0 else DRIFT)
	_arm.rotation.x = clampf(
		_arm.rotation.x + delta * TURN * Input.get_axis(&"ui_up", &"ui_down"), -1.2, 1.2
	)
	var away := Input.get_axis(&"ui_page_up", &"ui_page_down")
	_camera.position.z = clampf(_camera.position.z * exp(delta * away), 0.12, 4.0)


## Five shelves of books of all colours, upright, some leaning.
func _books() -> MultiMesh:
	var random := RandomNumberGenerator.new()
	random.seed = 4
	var books := MultiMesh.new()
	books.transform_format = MultiMesh.TRANSFORM_3D
	books.use_colors = true
	var book := BoxMesh.new()
	var cover := StandardMaterial3D.new()
	cover.vertex_color_use_as_albedo = true
	cover.vertex_color_is_srgb = true
	book.material = cover
	books.mesh = book
	books.instance_count = 5 * BOOKS_PER_SHELF
	for i in books.instance_count:
		@warning_ignore("integer_division")
		var shelf := i / BOOKS_PER_SHELF
		var size := Vector3(random.randf_range(0.02, 0.042), random.randf_range(0.22, 0.34), 0.2)
		var x := -1.15 + 2.3 * (i % BOOKS_PER_SHELF) / BOOKS_PER_SHELF
		var lean := Basis(Vector3.BACK, 0.22 if random.randf() < 0.06 else 0.0)
		var at := Vector3(x, 0.08 + 0.428 * shelf + 0.5 * size.y, 0.0)
		books.set_instance_transform(i, Transform3D(lean.scaled_local(size), at))
		var shade := random.randf_range(0.3, 0.75)
		var hue := HUES[random.randi() % HUES.size()]
		books.set_instance_color(i, Color.from_ok_hsl(hue, 0.5, shade))
	return books
