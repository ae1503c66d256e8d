# SPDX-License-Identifier: MIT
class_name PictureChoice
extends RefCounted
## What a visitor has chosen for the picture, and how a rung limits it. What somebody else changes
## meanwhile counts as chosen anew.

var sky: BlackHoleSky
var disk: AccretionDisk
var viewport: Viewport

var _chosen: Dictionary[StringName, Variant] = {}
var _written: Dictionary[StringName, Variant] = {}


## The picture as it is now is what the visitor wants.
func note() -> void:
	_chosen.clear()
	_written.clear()
	for name in _names():
		_note_one(name)


## Limits the picture to what a rung allows; null: as chosen.
func apply(rung: QualityRung) -> void:
	for name in _names():
		var owner := _owner_of(name)
		if not _written.has(name) or owner.get(name) != _written[name]:
			_note_one(name)
		var wanted: Variant = _chosen[name] if rung == null else _limited(name, rung)
		if owner.get(name) != wanted:
			owner.set(name, wanted)
		# As it reads back: some are kept with fewer digits than they are given with.
		_written[name] = owner.get(name)


func _names() -> Array[StringName]:
	var names: Array[StringName] = []
	if sky != null:
		names.append_array([&"image_orders", &"magnitude_limit", &"psf_model"])
	if disk != null:
		names.append(&"orders")
	if viewport != null:
		names.append(&"scaling_3d_scale")
	return names


func _owner_of(name: StringName) -> Object:
	match name:
		&"orders":
			return disk
		&"scaling_3d_scale":
			return viewport
	return sky


func _note_one(name: StringName) -> void:
	_chosen[name] = _owner_of(name).get(name)
	_written[name] = _chosen[name]


func _limited(name: StringName, rung: QualityRung) -> Variant:
	match name:
		&"image_orders":
			return mini(_chosen[name], rung.image_orders)
		&"magnitude_limit":
			return minf(_chosen[name], rung.magnitude_limit)
		&"psf_model":
			return BlackHoleSky.PSF_GAUSSIAN if rung.plain_stars else _chosen[name]
		&"orders":
			return mini(_chosen[name], rung.disk_orders)
	return minf(_chosen[name], rung.render_scale)
