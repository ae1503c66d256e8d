# SPDX-License-Identifier: MIT
class_name Main
extends Control
## Where the program starts: shows the title at once, a picture drawn beforehand, and brings up the
## scene that the command line asks for behind it.
##
## It names no class of that scene, whose scripts would then be read before the first picture.

## Seconds in which the picture gives way to the scene.
const FADE_SECONDS: float = 0.8
## The scene is taken as it is after so long, be it ready or not.
const LONGEST_WAIT_SECONDS: float = 20.0

var _path: String
var _waited: float = 0.0
var _scene: Node

@onready var _all: Control = %All


func _ready() -> void:
	set_process(false)
	get_window().content_scale_factor = PictureScale.text_scale(get_window().size)
	var interface := XRServer.find_interface("OpenXR")
	var headset_ready := interface != null and interface.is_initialized()
	var kind := ProgramMode.of(CommandLine.of_program(), headset_ready)
	_path = ProgramMode.SCENES[kind]
	if kind == ProgramMode.Kind.DESKTOP:
		RenderingServer.frame_post_draw.connect(_begin, CONNECT_ONE_SHOT)
	else:
		get_tree().change_scene_to_file.call_deferred(_path)


func _process(delta: float) -> void:
	if _scene == null:
		_take_scene()
		return
	_waited += delta
	if _is_seen() or _waited > LONGEST_WAIT_SECONDS:
		set_process(false)
		var fade := create_tween()
		fade.tween_property(_all, "modulate:a", 0.0, FADE_SECONDS)
		fade.tween_callback(queue_free)


# After the first picture, so that it does not wait for what is loaded.
func _begin() -> void:
	if ResourceLoader.load_threaded_request(_path) != OK:
		_give_up()
		return
	set_process(true)


func _take_scene() -> void:
	match ResourceLoader.load_threaded_get_status(_path):
		ResourceLoader.THREAD_LOAD_LOADED:
			var packed := ResourceLoader.load_threaded_get(_path) as PackedScene
			_scene = packed.instantiate()
			get_tree().root.add_child(_scene)
			get_tree().current_scene = _scene
			_scene.call(&"show_title")
		ResourceLoader.THREAD_LOAD_FAILED, ResourceLoader.THREAD_LOAD_INVALID_RESOURCE:
			_give_up()


func _is_seen() -> bool:
	return _scene.call(&"is_sky_ready") == true


func _give_up() -> void:
	set_process(false)
	push_error("%s cannot be loaded. Is the program complete?" % _path)
	get_tree().quit(1)
