# SPDX-License-Identifier: MIT
## Uses every class of the extension, at the ends of all ranges and beyond, and says so at the end.
## That nothing was wrong is the sanitizer's to say.
##
## Started as [code]godot --headless -s res://exercise.gd[/code].
extends SceneTree

const DATA := "res://addons/blackhole_sky/data/"
const END := "EXERCISE COMPLETE"
## What properties of a type are set to.
const ODD_VALUES: Dictionary[int, Array] = {
	TYPE_BOOL: [true, false],
	TYPE_INT: [0, 1, 2, -1, 1 << 20, -(1 << 31), 1 << 40],
	TYPE_FLOAT: [0.0, -1.0, 1e-30, 1e30, 0.5, 3.0, NAN, INF, -INF],
	TYPE_STRING: ["", "res://nowhere", DATA + "hipparcos.stars", "\u00e9\u00e9\u00e9"],
	TYPE_VECTOR3: [Vector3.ZERO, Vector3.UP, Vector3(NAN, INF, 1e30), Vector3(0, 0, 10)],
	TYPE_OBJECT: [null],
}

var _properties := 0


func _initialize() -> void:
	await process_frame
	var table := await _use_table()
	var catalogue := _use_catalogue()
	for cls in _classes():
		await _use_class(cls, table, catalogue)
	await _leave_while_baking()
	print("%d properties set" % _properties)
	if _properties > 40:
		print(END)
	quit()


## The classes of the extension.
func _classes() -> PackedStringArray:
	var found: PackedStringArray = []
	for cls in ClassDB.get_class_list():
		if (
			ClassDB.class_get_api_type(cls) == ClassDB.API_EXTENSION
			and ClassDB.can_instantiate(cls)
		):
			found.append(cls)
	return found


func _use_table() -> LensingTable:
	var table := LensingTable.new()
	assert(table.load_file(DATA + "schwarzschild.lut") == OK)
	assert(table.save_file("user://copy.lut") == OK)
	for wrong: String in [DATA + "hipparcos.stars", "res://project.godot", "res://nowhere.lut", ""]:
		table.load_file(wrong)
	table.bake()
	table.bake()
	table.cancel_bake()
	while table.is_baking():
		await process_frame
	table.bake()
	while table.is_baking():
		await process_frame
	assert(table.is_ready() and table.get_inverse_texels().size() > 0)
	for place: Vector3 in [Vector3.ZERO, Vector3(0, 0, 1), Vector3(1e20, 0, 0), Vector3(NAN, 1, 1)]:
		for order in [-1, 0, 1, 99]:
			LensingTable.star_image(place, Vector3.UP, order, LensingTable.MOTION_RAIN)
		LensingTable.trace(place, Vector3.FORWARD, LensingTable.MOTION_STATIC)
	return table


func _use_catalogue() -> StarCatalogue:
	var catalogue := StarCatalogue.new()
	assert(catalogue.load_file(DATA + "hipparcos.stars") == OK)
	for wrong: String in [
		DATA + "schwarzschild.lut", DATA + "constellations.json", "res://nowhere.csv", ""
	]:
		catalogue.load_file(wrong)
	for index in [-1, 0, 5, 1 << 30]:
		catalogue.get_star_name(index)
		catalogue.get_star_direction(index)
	assert(catalogue.get_star_count() > 100000)
	var few := StarCatalogue.new()
	few.set_stars([Vector3.UP, Vector3(NAN, 0, 0)], [1.0, 2.0])
	few.set_stars([Vector3.UP], [1.0, 2.0])
	few.set_stars([Vector3.UP, Vector3(1e30, 0, 0)], [-1e30, 1e30], [1e-30, 1e30])
	return few


## Sets each property to values of its type at and beyond the ends, while the object works; then
## frees it.
func _use_class(cls: String, table: LensingTable, catalogue: StarCatalogue) -> void:
	var object: Object = ClassDB.instantiate(cls)
	var node := object as Node
	if node != null:
		var world := SubViewport.new()
		root.add_child(world)
		world.add_child(Camera3D.new())
		world.add_child(node)
		await process_frame
	var sky := object as BlackHoleSky
	if sky != null:
		sky.table = table
		sky.catalogue = catalogue
		await process_frame
	for property in ClassDB.class_get_property_list(cls, true):
		if int(property["usage"]) & PROPERTY_USAGE_EDITOR != 0:
			await _use_property(object, property, node != null)
	if node != null:
		node.get_parent().queue_free()
		await process_frame
	elif object is not RefCounted:
		object.free()


func _use_property(object: Object, property: Dictionary, draws: bool) -> void:
	var name: String = property["name"]
	var before: Variant = object.get(name)
	_properties += 1
	for value: Variant in _values(property):
		object.set(name, value)
		object.get(name)
		if draws:
			await process_frame
	object.set(name, before)


func _values(property: Dictionary) -> Array:
	var type: int = property["type"]
	var hint: String = property["hint_string"]
	var values: Array = ODD_VALUES.get(type, [null, type_convert(null, type)])
	if type == TYPE_FLOAT:
		for word in hint.split(",").slice(0, 2):
			values = values + [word.to_float()]
	return values


## Tables and nodes that are freed while they are at work.
func _leave_while_baking() -> void:
	for i in 5:
		var table := LensingTable.new()
		table.bake()
		for frame in i:
			await process_frame
		table = null
	var sky := BlackHoleSky.new()
	root.add_child(sky)
	await process_frame
	sky.free()
