# SPDX-License-Identifier: MIT
class_name PicturePage
extends VBoxContainer
## Lines and names over the sky, how the light of a star spreads, how the sky is laid out on the
## picture and on a map beside it, and how many images of each star there are.

var sky: BlackHoleSky
var overlays: SkyOverlays
var map: MapWindow

@onready var _constellations: CheckBox = %Constellations
@onready var _star_names: CheckBox = %StarNames
@onready var _spread: Stepper = %Spread
@onready var _projection: Stepper = %Projection
@onready var _map: Stepper = %MapBeside
@onready var _orders: Stepper = %Orders
@onready var _lines: Dictionary[BlackHoleSky.Overlay, CheckBox] = {
	BlackHoleSky.OVERLAY_EQUATORIAL_GRID: %EquatorialGrid,
	BlackHoleSky.OVERLAY_GALACTIC_GRID: %GalacticGrid,
	BlackHoleSky.OVERLAY_SHADOW_EDGE: %ShadowEdge,
	BlackHoleSky.OVERLAY_EINSTEIN_RINGS: %EinsteinRings,
	BlackHoleSky.OVERLAY_MOTION: %Motion,
	BlackHoleSky.OVERLAY_SHADOW_DIAMETER: %ShadowDiameter,
	BlackHoleSky.OVERLAY_STRAIGHT_LIGHT: %StraightLight,
}


func _ready() -> void:
	_constellations.toggled.connect(overlays.want_constellations)
	_star_names.toggled.connect(overlays.want_star_names)
	for line in _lines:
		_lines[line].toggled.connect(func(on: bool) -> void: overlays.want(line, on))
	_spread.chosen.connect(_on_spread_chosen)
	_projection.chosen.connect(_on_projection_chosen)
	_map.chosen.connect(_on_map_chosen)
	_orders.chosen.connect(func(at: int) -> void: sky.image_orders = at + 1)
	sky.quality_changed.connect(_show_quality)
	_show_quality()


func refresh() -> void:
	_constellations.set_pressed_no_signal(overlays.are_constellations_wanted())
	_star_names.set_pressed_no_signal(overlays.are_star_names_shown())
	for line in _lines:
		_lines[line].set_pressed_no_signal(sky.overlays & line != 0)
	_spread.titles = spread_titles(sky.aperture_mm)
	_projection.titles = projection_titles()
	_projection.at = sky.projection
	var maps := projection_titles()
	maps[0] = tr("None")
	_map.titles = maps
	_map.at = map.get_projection() if map.visible else BlackHoleSky.PROJECTION_PERSPECTIVE
	var counts := PackedStringArray()
	for orders in SkySwitches.MOST_ORDERS:
		counts.append(str(orders + 1))
	_orders.titles = counts


## What spreads a star's light, in the order of [enum BlackHoleSky.PointSpreadModel], with the
## aperture in millimetres.
static func spread_titles(aperture: float) -> PackedStringArray:
	return [
		_translated("Gaussian"),
		_translated("Diffraction, %s mm") % String.num(aperture, 2),
		_translated("Glare in the eye"),
	]


## In the order of [enum BlackHoleSky.Projection].
static func projection_titles() -> PackedStringArray:
	return [
		_translated("Perspective"),
		_translated("Equirectangular"),
		_translated("Mercator"),
		_translated("Mollweide"),
		_translated("Fisheye 180°"),
		_translated("Fisheye 220°"),
		_translated("Fisheye 360°"),
	]


func _show_quality() -> void:
	_spread.at = sky.psf_model
	_orders.at = sky.image_orders - 1


func _on_spread_chosen(at: int) -> void:
	sky.psf_model = at as BlackHoleSky.PointSpreadModel


func _on_projection_chosen(at: int) -> void:
	sky.projection = at as BlackHoleSky.Projection


func _on_map_chosen(at: int) -> void:
	if at == BlackHoleSky.PROJECTION_PERSPECTIVE:
		map.close()
	else:
		map.set_projection(at as BlackHoleSky.Projection)
		map.open()


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
