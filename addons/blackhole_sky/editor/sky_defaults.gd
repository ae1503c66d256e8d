# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## What the project's settings give a sky that lacks its data: table, stars, background. Every gift
## can be undone.

const ProjectPage := preload("project_page.gd")
const GIVE: String = "Give Sky Its Data"


## Property and value of what `sky` lacks; empty where nothing is amiss.
static func missing(sky: BlackHoleSky) -> Dictionary[StringName, Variant]:
	var gifts: Dictionary[StringName, Variant] = {}
	if sky.table == null:
		_add(gifts, &"table", ProjectPage.TABLE, &"LensingTable")
	if sky.catalogue == null:
		_add(gifts, &"catalogue", ProjectPage.CATALOGUE, &"StarCatalogue")
	if sky.panorama == null and sky.background == BlackHoleSky.BACKGROUND_NONE:
		_add(gifts, &"panorama", ProjectPage.PANORAMA, &"Texture2D")
		if gifts.has(&"panorama"):
			gifts[&"panorama_luminance"] = ProjectPage.value(ProjectPage.PANORAMA_LUMINANCE)
			gifts[&"background"] = BlackHoleSky.BACKGROUND_PANORAMA
	return gifts


## The same for a sky that has just been made, with the exposure and the faintest stars that new
## ones get.
static func of_new(sky: BlackHoleSky) -> Dictionary[StringName, Variant]:
	var gifts := missing(sky)
	gifts[&"exposure"] = ProjectPage.value(ProjectPage.EXPOSURE)
	gifts[&"magnitude_limit"] = ProjectPage.value(ProjectPage.MAGNITUDE_LIMIT)
	return gifts


## True of a sky as the engine makes it, to which nobody has given any data.
static func is_bare(sky: BlackHoleSky) -> bool:
	return (
		sky.table == null
		and sky.catalogue == null
		and sky.panorama == null
		and sky.background == BlackHoleSky.BACKGROUND_NONE
	)


## Sets the properties as one step that can be undone.
static func give(sky: BlackHoleSky, gifts: Dictionary[StringName, Variant]) -> void:
	if gifts.is_empty():
		return
	var undo := EditorInterface.get_editor_undo_redo()
	undo.create_action(GIVE, UndoRedo.MERGE_DISABLE, sky)
	for property: StringName in gifts:
		undo.add_do_property(sky, property, gifts[property])
		undo.add_undo_property(sky, property, sky.get(property))
	undo.commit_action()


static func _add(
	gifts: Dictionary[StringName, Variant], property: StringName, setting: String, type: StringName
) -> void:
	var path: String = ProjectPage.value(setting)
	if path.is_empty():
		return
	if not ResourceLoader.exists(path):
		push_warning("%s: there is no %s. Correct the project setting." % [setting, path])
		return
	var found := load(path)
	if found != null and found.is_class(type):
		gifts[property] = found
	else:
		push_warning("%s: %s is no %s. Correct the project setting." % [setting, path, type])
