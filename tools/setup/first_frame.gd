# SPDX-License-Identifier: MIT
extends SceneTree
## Opens the project's main scene (an empty one where there is none) and prints how long it took
## from the start of the engine until the first frame was drawn, and until the sky had taken the
## place of the first picture.


func _initialize() -> void:
	var path: String = ProjectSettings.get_setting("application/run/main_scene", "")
	if path.is_empty():
		root.add_child(Camera3D.new())
	else:
		var scene: PackedScene = load(path)
		var main := scene.instantiate()
		main.tree_exited.connect(_on_sky)
		root.add_child(main)
	RenderingServer.frame_post_draw.connect(_on_first_frame, CONNECT_ONE_SHOT)


func _on_first_frame() -> void:
	print("first frame after %.3f ms" % (Time.get_ticks_usec() / 1000.0))
	if ProjectSettings.get_setting("application/run/main_scene", "") == "":
		quit(0)


func _on_sky() -> void:
	print("sky after %.3f ms" % (Time.get_ticks_usec() / 1000.0))
	quit(0)
