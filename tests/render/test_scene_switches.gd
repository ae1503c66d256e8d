# SPDX-License-Identifier: MIT
extends GutTest
## Turning from scene to scene leaves nothing behind: no object, no node, no memory.

const FOLDER: String = "res://scenes/examples/"
const SCENES: PackedStringArray = [
	"01_minimal_sky/minimal_sky.tscn",
	"03_disk/disk.tscn",
	"02_own_catalogue/own_catalogue.tscn",
	"04_fall_ride/fall_ride.tscn",
]
const SWITCHES: int = 200
const FEW: int = 4
## Of static memory a switch may leave so much, bytes: the engine's own pools grow in steps.
const PER_SWITCH: float = 400.0
const COUNTED: Dictionary[String, Performance.Monitor] = {
	"objects": Performance.OBJECT_COUNT,
	"resources": Performance.OBJECT_RESOURCE_COUNT,
	"nodes": Performance.OBJECT_NODE_COUNT,
	"orphans": Performance.OBJECT_ORPHAN_NODE_COUNT,
	"bytes of textures": Performance.RENDER_TEXTURE_MEM_USED,
	"bytes of buffers": Performance.RENDER_BUFFER_MEM_USED,
}

var _viewport := SubViewport.new()

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_viewport.size = Vector2i(64, 36)
	_viewport.own_world_3d = true
	_viewport.use_hdr_2d = SkyBooth.is_linear()
	_viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(_viewport)


func after_all() -> void:
	_viewport.free()


func test_nothing_is_left() -> void:
	var switches := SWITCHES if RendererScope.is_everything_wanted() else FEW
	for warming_up in SCENES.size():
		await _open_and_leave(SCENES[warming_up])
	var before := _counts()
	var memory := Performance.get_monitor(Performance.MEMORY_STATIC)
	for turn in switches:
		await _open_and_leave(SCENES[turn % SCENES.size()])
	assert_eq(_counts(), before, "after %d switches" % switches)
	var grown := Performance.get_monitor(Performance.MEMORY_STATIC) - memory
	gut.p("%d switches, %d bytes more" % [switches, grown])
	assert_lt(grown, PER_SWITCH * switches + 20000.0, "bytes of static memory")


## Opens a scene, lets it draw and leaves it.
func _open_and_leave(scene: String) -> void:
	var packed: PackedScene = ResourceLoader.load(
		FOLDER + scene, "", ResourceLoader.CACHE_MODE_IGNORE
	)
	_viewport.add_child(packed.instantiate())
	await RenderingServer.frame_post_draw
	_viewport.get_child(0).free()
	packed = null
	await RenderingServer.frame_post_draw


func _counts() -> Dictionary[String, int]:
	var counts: Dictionary[String, int] = {}
	for what in COUNTED:
		counts[what] = int(Performance.get_monitor(COUNTED[what]))
	return counts
