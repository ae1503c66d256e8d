# SPDX-License-Identifier: MIT
class_name ShotFromScene
extends RefCounted
## Describes what a scene shows as a shot: the JSON from which ./run capture draws the same picture.

## What a hole that comes or goes lacks of being there or gone, and still counts as such.
const SETTLED: float = 1e-6

## The shot, or empty where there is none.
var shot: Dictionary = {}
## Why there is none, in the language of the display.
var refusal: String = ""

var _sky: BlackHoleSky
var _has_hole: bool = true
# The eye's place in Schwarzschild radii and its axes, both in those of the sky.
var _place := Vector3.ZERO
var _axes := Basis.IDENTITY


## What `camera` sees of `sky`, drawn with `resolution`; `disk` and `labels` may be null.
static func describe(
	sky: BlackHoleSky,
	camera: Camera3D,
	resolution: Vector2i,
	disk: AccretionDisk = null,
	labels: SkyLabels = null
) -> ShotFromScene:
	var described := ShotFromScene.new()
	described._sky = sky
	described._write(camera, resolution, disk, labels)
	if not described.refusal.is_empty():
		described.shot = {}
	return described


## The file's text: all digits that single precision has, and more.
func to_json() -> String:
	return JSON.stringify(shot, "  ", false, true) + "\n"


func _write(camera: Camera3D, resolution: Vector2i, disk: AccretionDisk, labels: SkyLabels) -> void:
	_has_hole = _sky.lensing > SETTLED
	if _has_hole and _sky.lensing < 1.0 - SETTLED:
		refusal = _translated("The hole is coming or going: wait until it is there or gone.")
	elif _sky.background == BlackHoleSky.BACKGROUND_PANORAMA and not _shows_milky_way():
		refusal = _translated("Only the addon's own panorama can be photographed.")
	var to_sky := _sky.global_transform.orthonormalized().affine_inverse()
	_place = to_sky * camera.global_position / _sky.schwarzschild_radius
	_axes = to_sky.basis * camera.global_basis.orthonormalized()
	shot = {
		"resolution": [resolution.x, resolution.y],
		"vertical_fov_deg": camera.fov,
		"projection": ShotSpec.PROJECTIONS[_sky.projection],
		"position_rs": _list(_place),
		"look_at_rs": _ahead(),
		"up": _list(_axes.y),
		"observer": _observer(),
		"renderer": RenderingServer.get_current_rendering_method(),
		"stars": _stars(),
		"background": _background(),
		"effects": _effects(),
		"psf": _point_spread(),
		"exposure": _sky.get_effective_exposure(),
		"overlays": _overlays(labels),
		"language": "de" if TranslationServer.get_locale().begins_with("de") else "la",
		"disk": null,
	}
	if disk != null and disk.visible:
		shot["disk"] = _disk(disk)
	if not _has_hole:
		shot["hole"] = false


func _shows_milky_way() -> bool:
	return _sky.panorama != null and _sky.panorama.resource_path == MilkyWay.FILE


# A point straight ahead, in double precision.
func _ahead() -> Array[float]:
	var forward := -_axes.z
	return [
		float(_place.x) + float(forward.x),
		float(_place.y) + float(forward.y),
		float(_place.z) + float(forward.z),
	]


# The observer that is drawn, which is another than the chosen one where that cannot be.
func _observer() -> Variant:
	var observer := _sky.observer if _sky.observer != null else SkyObserver.new()
	if not _has_hole:
		if observer.motion == LensingTable.MOTION_VELOCITY:
			return _velocity(observer)
		return "static"
	if not observer.get_refusal(_place).is_empty():
		var falls := observer.motion == LensingTable.MOTION_INFALL
		return "static" if falls and _place.length() > 1.0 else "rain"
	var described := {"motion": ShotObserver.MOTIONS[observer.motion]}
	match observer.motion:
		LensingTable.MOTION_INFALL:
			described["energy"] = observer.energy
			described["outgoing"] = observer.outgoing
		LensingTable.MOTION_ORBIT:
			described["axis"] = _list(observer.axis)
		LensingTable.MOTION_VELOCITY:
			described = _velocity(observer)
	return described


func _velocity(observer: SkyObserver) -> Dictionary:
	var velocity := {"motion": "velocity", "celerity": _list(observer.celerity)}
	if _has_hole:
		velocity["relative_to"] = "static" if observer.relative_to_static else "rain"
	return velocity


func _stars() -> Variant:
	if _sky.catalogue == null or not _sky.stars_visible:
		return null
	return {"magnitude_limit": _sky.magnitude_limit, "orders": _sky.image_orders}


func _background() -> String:
	match _sky.background:
		BlackHoleSky.BACKGROUND_GRID:
			return "grid"
		BlackHoleSky.BACKGROUND_PANORAMA:
			return "milky_way"
	return "none"


func _effects() -> Dictionary:
	var effects := {}
	for switch in ShotEffects.SWITCHES:
		effects[switch] = _sky.get("effect_" + switch)
	effects["redshift_map"] = _sky.redshift_map
	effects["saturation"] = _sky.saturation
	return effects


# Stars grow with the picture, as on the screen.
func _point_spread() -> Dictionary:
	var rows: int = shot.get("resolution", [0, 0])[1]
	var spread := {
		"model": ShotPointSpread.MODELS[_sky.psf_model], "sigma_px": PictureScale.star_sigma(rows)
	}
	match _sky.psf_model:
		BlackHoleSky.PSF_AIRY:
			spread["aperture_mm"] = _sky.aperture_mm
		BlackHoleSky.PSF_EYE:
			spread["glare"] = _sky.glare
	return spread


func _overlays(labels: SkyLabels) -> Array[String]:
	var names: Array[String] = []
	for bit in ShotSpec.OVERLAYS.size():
		var of_hole := 1 << bit & SkyOverlays.OF_HOLE & ~BlackHoleSky.OVERLAY_MOTION
		if _sky.overlays & 1 << bit and (_has_hole or not of_hole):
			names.append(ShotSpec.OVERLAYS[bit])
	if labels != null and labels.visible and labels.stars_shown:
		names.append("star_names")
	if labels != null and labels.visible and labels.constellations_shown:
		names.append("constellation_names")
	return names


func _disk(disk: AccretionDisk) -> Dictionary:
	var axes := disk.basis.orthonormalized()
	var turned := ShotDisk.untwisted(axes.y).inverse() * axes
	var described := {
		"normal": _list(axes.y),
		"turn_deg": rad_to_deg(atan2(turned.x.dot(Vector3.FORWARD), turned.x.x)),
		"look": ShotDisk.LOOKS[disk.look],
		"mass_solar": _sky.mass_solar,
	}
	for key: String in ShotDisk.PROPERTIES:
		var value: Variant = disk.get(ShotDisk.PROPERTIES[key])
		described[key] = Array(disk.ring_radii) if key == "ring_radii_rs" else value
	return described


static func _list(vector: Vector3) -> Array[float]:
	return [vector.x, vector.y, vector.z]


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
