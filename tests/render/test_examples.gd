# SPDX-License-Identifier: MIT
extends GutTest
## Every example draws what it says: a dark hole in a sky with light in it.
##
## With BLACKHOLE_PICTURES set, the pictures are written to that folder.

const FOLDER: String = "res://scenes/examples/"
const SIZE := Vector2i(480, 270)
## What follows the hole's middle in the picture is not dark in front of a disk.
const DARK: float = 2e-3

var _examples: Array = (
	ParameterFactory
	. named_parameters(
		["scene", "dark_middle"],
		[
			["01_minimal_sky/minimal_sky.tscn", true],
			["02_own_catalogue/own_catalogue.tscn", true],
			["03_disk/disk.tscn", false],
			["04_fall_ride/fall_ride.tscn", true],
			["05_room/everyday_room.tscn", true],
			["07_xr/xr_example.tscn", false],
		]
	)
)

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func test_it_draws(p: Variant = use_parameters(_examples)) -> void:
	var path: String = p.scene
	var viewport := SubViewport.new()
	viewport.size = SIZE
	viewport.own_world_3d = true
	viewport.use_hdr_2d = SkyBooth.is_linear()
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child_autofree(viewport)
	var packed: PackedScene = load(FOLDER + path)
	var example := packed.instantiate()
	_spare(example.get_node_or_null(^"Sky/Surroundings"))
	viewport.add_child(example)
	var sky: BlackHoleSky = example.get_node("Sky")
	assert_eq(sky.get_warnings(), PackedStringArray(), "nothing is missing")
	for frame in 5:
		await RenderingServer.frame_post_draw
	var picture := viewport.get_texture().get_image()
	await _keep(picture, path)
	var light := PictureMeasure.of_image(picture)
	var lit := 0
	for value in light.luminance:
		lit += 1 if value > 0.01 else 0
	assert_gt(lit, 150, "pixels with light")
	if p.dark_middle:
		var middle := (SIZE.y >> 1) * SIZE.x + (SIZE.x >> 1)
		assert_lt(light.luminance[middle], DARK, "the shadow")


## Six views of a room take software long.
func _spare(capture: SurroundingsCapture) -> void:
	if capture != null:
		capture.update_mode = SurroundingsCapture.UpdateMode.ONCE
		capture.resolution = 128
		capture.msaa_3d = Viewport.MSAA_DISABLED


func test_each_has_its_readme_and_a_short_script() -> void:
	var folders := DirAccess.get_directories_at(FOLDER)
	assert_gt(folders.size(), 5)
	for folder in folders:
		assert_file_exists(FOLDER + folder + "/README.md")
		for file in DirAccess.get_files_at(FOLDER + folder):
			if file.ends_with(".gd"):
				var text := FileAccess.get_file_as_string(FOLDER + folder + "/" + file)
				assert_lte(text.count("\n"), 60, file)


func _keep(picture: Image, path: String) -> void:
	var folder := OS.get_environment("BLACKHOLE_PICTURES")
	if folder.is_empty():
		return
	var encoder := DisplayEncoder.new()
	add_child_autofree(encoder)
	var shown: Image = await encoder.encode(picture)
	shown.save_png(folder.path_join(path.get_file().get_basename() + ".png"))
