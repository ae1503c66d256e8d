# SPDX-License-Identifier: MIT
class_name TourSky
extends RefCounted
## What a station and a caption ask of the sky itself: background, images, lines, disk, exposure,
## and the hole or none.

## Seconds in which 63 % of a change of the exposure is made.
const SETTLING: float = 0.7
## Seconds in which the hole comes or goes.
const HOLE_SECONDS: float = 2.5
const GROUNDS: Dictionary[TourStation.Ground, BlackHoleSky.Background] = {
	TourStation.Ground.STARS_ALONE: BlackHoleSky.BACKGROUND_NONE,
	TourStation.Ground.GRID: BlackHoleSky.BACKGROUND_GRID,
	TourStation.Ground.MILKY_WAY: BlackHoleSky.BACKGROUND_PANORAMA,
}
const EFFECTS: Array[StringName] = [
	&"effect_deflection",
	&"effect_aberration",
	&"effect_gravitational_shift",
	&"effect_doppler",
	&"effect_magnification",
	&"effect_higher_orders",
]
const PRESETS: Dictionary[TourStation.Disk, String] = {
	TourStation.Disk.MUSEUM: "museum",
	TourStation.Disk.PHYSICIST: "physicist",
	TourStation.Disk.FILM: "film",
}

var sky: BlackHoleSky
var switches: SkySwitches
var disk: DiskSwitches
## None: neither constellations nor names are shown.
var overlays: SkyOverlays
## In a headset the exposure does not follow the light.
var in_headset: bool = false

var _station: TourStation
var _memory := KeptProperties.new()
var _hole_before: bool = true
var _constellations_before: bool = false
var _names_before: bool = false
# Others change the exposure too: only differences are added.
var _exposure: float = 0.0
var _exposure_wanted: float = 0.0
# How far the hole has come, 0 to 1, before it is smoothed.
var _hole: float = 1.0
var _hole_wanted: float = 1.0
var _exposure_before: float = 0.0


func remember() -> void:
	_hole_before = switches.is_hole_wanted()
	switches.want_hole(true)
	_hole = sky.lensing
	_exposure = sky.exposure
	_exposure_wanted = _exposure
	_exposure_before = _exposure
	var kept: Array[StringName] = [&"background", &"image_orders", &"overlays", &"projection"]
	kept.append_array([&"redshift_map", &"auto_exposure", &"stars_visible", &"see_through"])
	kept.append_array(EFFECTS)
	_memory.keep(sky, kept)
	_memory.keep(disk, [&"preset", &"inclination"])
	# After the preset, which sets most of them.
	var looks: Array[StringName] = [&"visible", &"basis"]
	for property: String in DiskPresets.values(DiskPresets.DEFAULT):
		looks.append(property)
	_memory.keep(disk.disk, looks)
	if overlays != null:
		_constellations_before = overlays.are_constellations_wanted()
		_names_before = overlays.are_star_names_shown()


## All is as when it was remembered.
func restore() -> void:
	if overlays != null:
		overlays.want_constellations(_constellations_before)
		overlays.want_star_names(_names_before)
	_memory.restore()
	_exposure_wanted = _exposure_before
	_hole_wanted = 1.0
	advance(INF)
	switches.want_hole(_hole_before)


## Shows a station's sky.
func show_station(station: TourStation) -> void:
	_station = station
	sky.background = GROUNDS[station.ground]
	if sky.background == BlackHoleSky.BACKGROUND_PANORAMA and sky.panorama == null:
		sky.background = BlackHoleSky.BACKGROUND_GRID
	sky.projection = BlackHoleSky.PROJECTION_PERSPECTIVE
	sky.redshift_map = false
	sky.see_through = 0.0
	sky.stars_visible = true
	sky.auto_exposure = station.adapts and not in_headset
	for effect in EFFECTS:
		sky.set(effect, true)
	disk.disk.visible = PRESETS.has(station.disk)
	if disk.disk.visible:
		disk.preset = PRESETS[station.disk]
		disk.inclination = station.disk_inclination
	if overlays != null:
		overlays.want_star_names(station.star_names)


## Shows what a caption changes.
func show_caption(index: int) -> void:
	var caption := _station.captions[index]
	sky.image_orders = _station.get_orders_at(index)
	_hole_wanted = 0.0 if caption.without_hole else 1.0
	_exposure_wanted = _station.exposure + caption.exposure_change
	if in_headset:
		_exposure_wanted += _station.headset_brighter
	var lines := _station.lines | caption.more_lines
	var figures := BlackHoleSky.OVERLAY_CONSTELLATIONS
	if overlays != null:
		overlays.want_constellations(lines & figures != 0)
		lines = lines & ~figures | sky.overlays & figures
	sky.overlays = lines


## Lets `seconds` pass; INF: all is as it is to be.
func advance(seconds: float) -> void:
	var next := lerpf(_exposure_wanted, _exposure, exp(-seconds / SETTLING))
	sky.exposure += next - _exposure
	_exposure = next
	_hole = move_toward(_hole, _hole_wanted, seconds / HOLE_SECONDS)
	var lensing := smoothstep(0.0, 1.0, _hole)
	if sky.lensing != lensing:
		sky.lensing = lensing
