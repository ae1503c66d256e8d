# SPDX-License-Identifier: MIT
extends SceneTree
## Command line: draws every page and station of the programs in every language and size, and says
## which texts cannot be read.
##
##     godot --path . -s res://scenes/screens/screens.gd -- OUT/ [PATTERN]
##
## With a PATTERN, such as tour_*, only the pages whose names match. Quits with 1 when a text is cut
## off, covered or too faint.

const SIZES: Array[Vector2i] = [Vector2i(1280, 720), Vector2i(1920, 1080)]
const LOCALES: PackedStringArray = ["en", "de"]
const DESKTOP: String = "res://scenes/desktop/desktop.tscn"
## Frames until a page has settled, and more of them for what fades in.
const SETTLING_FRAMES: int = 4
const FADING_SECONDS: float = 0.6

var _folder: String
var _pattern: String = "*"
var _problems := PackedStringArray()
var _encoder := DisplayEncoder.new()


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments := OS.get_cmdline_user_args()
	if arguments.is_empty() or arguments.size() > 2:
		printerr("screens: give the folder for the pictures and, if wanted, a pattern of names.")
		quit(2)
		return
	_folder = arguments[0]
	if arguments.size() == 2:
		_pattern = arguments[1]
	root.add_child(_encoder)
	for size in SIZES:
		for locale in LOCALES:
			if not await _draw_all(size, locale):
				quit(1)
				return
	for problem in _problems:
		print(problem)
	print("%d texts that cannot be read" % _problems.size())
	quit(0 if _problems.is_empty() else 1)


func _draw_all(size: Vector2i, locale: String) -> bool:
	var folder := _folder.path_join("%dx%d" % [size.x, size.y]).path_join(locale)
	if DirAccess.make_dir_recursive_absolute(folder) != OK:
		printerr("screens: %s cannot be made. Check the path and the disk." % folder)
		return false
	DisplayServer.window_set_size(size)
	var packed: PackedScene = load(DESKTOP)
	var scene := packed.instantiate() as DesktopScene
	root.add_child(scene)
	TranslationServer.set_locale(locale)
	var screens := DesktopScreens.new(scene)
	for name in screens.get_names():
		if name.match(_pattern):
			screens.show(name)
			await _settle()
			await _take(scene, folder.path_join(name + ".png"), "%s %s" % [size, locale])
			screens.clear()
	await _draw_exhibit(scene, folder, "%s %s" % [size, locale])
	scene.queue_free()
	await process_frame
	return true


func _settle() -> void:
	await create_timer(FADING_SECONDS).timeout
	for frame in SETTLING_FRAMES:
		await RenderingServer.frame_post_draw


func _take(scene: Node, file: String, where: String) -> void:
	var picture: Image = await _encoder.encode(root.get_texture().get_image())
	if picture.save_png(file) != OK:
		printerr("screens: %s cannot be written. Check the path and the disk." % file)
	print(file)
	for problem in TextCheck.misplaced(scene) + TextCheck.faint(scene, picture):
		_problems.append("%s %s: %s" % [where, file.get_file().get_basename(), problem])


# The exhibit's own pages, over the sky of the demo without its display.
func _draw_exhibit(scene: DesktopScene, folder: String, where: String) -> void:
	(scene.get_node("Display") as CanvasLayer).hide()
	var exhibit := ExhibitScreens.new()
	root.add_child(exhibit)
	for name in exhibit.get_names():
		if name.match(_pattern):
			exhibit.show_page(name)
			await _settle()
			await _take(exhibit, folder.path_join(name + ".png"), where)
			exhibit.clear()
	exhibit.queue_free()
