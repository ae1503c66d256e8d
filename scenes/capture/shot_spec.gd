# SPDX-License-Identifier: MIT
class_name ShotSpec
extends RefCounted
## A still or a sequence to be taken: what is where, who looks, how it is drawn.
##
## Read from JSON. The schema beside this file says which keys there are, their types and ranges;
## here is checked what a schema cannot say. What is refused is refused by name. Positions are in
## Schwarzschild radii, hole at the origin, y to the north celestial pole.

enum Background { NONE, GRID, MILKY_WAY, FILE }

const SCHEMA_FILE: String = "res://scenes/capture/shot.schema.json"
## Of a shot's file, and of a list of shots: some 40,000 keyframes.
const MOST_BYTES: int = 4 << 20
const BACKGROUNDS: PackedStringArray = ["none", "grid", "milky_way"]
## In the order of the bits of BlackHoleSky.Overlay.
const OVERLAYS: PackedStringArray = [
	"constellations",
	"equatorial_grid",
	"galactic_grid",
	"shadow_edge",
	"einstein_rings",
	"motion",
	"shadow_diameter",
	"straight_light",
]
## In the order of BlackHoleSky.Projection.
const PROJECTIONS: PackedStringArray = [
	"perspective",
	"equirectangular",
	"mercator",
	"mollweide",
	"fisheye_180",
	"fisheye_220",
	"fisheye_360",
]
const VERTICAL_FOV_DEG: float = 60.0
const UPWARD: PackedFloat64Array = [0.0, 1.0, 0.0]

var resolution := Vector2i(1280, 720)
var vertical_fov_deg: float = VERTICAL_FOV_DEG
var projection: BlackHoleSky.Projection = BlackHoleSky.PROJECTION_PERSPECTIVE
## Whether there is a hole. Without it the eye is at rest or has a given velocity.
var hole: bool = true
## Where the eye is, in double precision.
var position: PackedFloat64Array = [0.0, 0.0, 10.0]
## Viewing direction and the picture's upward direction, unit vectors, in double precision.
var forward: PackedFloat64Array = [0.0, 0.0, -1.0]
var up: PackedFloat64Array = UPWARD
## How the eye moves.
var observer := ShotObserver.new()
var renderer: String = "mobile"
## Whether the shot names its renderer; if not, the one that runs will do.
var renderer_named: bool = false
var has_stars: bool = true
## Path of a catalogue, or "builtin".
var catalogue: String = "builtin"
var magnitude_limit: float = 7.0
var orders: int = 2
var lensing: bool = true
var psf_sigma_px: float = 1.0
var exposure_ev: float = 0.0
## Null: the exposure is `exposure_ev`.
var auto_exposure: ShotAutoExposure
var effects := ShotEffects.new()
var point_spread := ShotPointSpread.new()
## Null: a camera takes the picture, no headset.
var headset: ShotHeadset
## Null: there is no accretion disk.
var disk: ShotDisk
## Bits of BlackHoleSky.Overlay.
var overlays: int = 0
var star_names: bool = false
var constellation_names: bool = false
## Of the constellations' names.
var language: String = "la"
var background: Background = Background.NONE
var background_file: String = ""
## Of a sequence, seconds from its start.
var seconds: float = 0.0
## Of a sequence: its frames; the spec is that of the frame last gone to. Null for a still.
var sequence: ShotPath
## Why the shot was refused; empty when it is fine.
var error: String = ""

var _files: ShotFiles


## Reads a shot from a file. Paths inside are looked up beside it, then in the `further_folder`.
static func from_file(path: String, further_folder: String = "") -> ShotSpec:
	var file := BoundedText.from_file(path, MOST_BYTES)
	if not file.error.is_empty():
		var refused := ShotSpec.new()
		refused.error = "Shot file %s %s" % [path, file.error]
		return refused
	var parser := JSON.new()
	if parser.parse(file.text) != OK:
		var refused := ShotSpec.new()
		refused.error = (
			"Shot file %s is no JSON: line %d: %s."
			% [path, parser.get_error_line() + 1, parser.get_error_message()]
		)
		return refused
	return from_data(parser.data, [path.get_base_dir(), further_folder])


## Reads a shot from parsed JSON; `folders` are where relative paths are looked up.
static func from_data(data: Variant, folders: PackedStringArray = []) -> ShotSpec:
	var spec := ShotSpec.new()
	spec._files = ShotFiles.new(folders)
	spec.error = JsonSchema.from_file(SCHEMA_FILE).check(data)
	if spec.error.is_empty():
		spec._read(data)
	return spec


## Puts the eye where a sequence has it in a frame, from 0 on.
func go_to(frame: int) -> void:
	seconds = frame / sequence.fps
	_read_pose(sequence.pose(frame))
	if not error.is_empty():
		error = sequence.fault(frame, error)


func _read(data: Dictionary) -> void:
	var size: PackedInt32Array = data.get("resolution", [resolution.x, resolution.y])
	resolution = Vector2i(size[0], size[1])
	projection = PROJECTIONS.find(data.get("projection", PROJECTIONS[0])) as BlackHoleSky.Projection
	renderer = data.get("renderer", renderer)
	renderer_named = data.has("renderer")
	hole = data.get("hole", hole)
	if data.has("path"):
		_read_path(data)
	else:
		_read_pose(data)
	if error.is_empty():
		_read_stars(data)
	if error.is_empty():
		_read_background(data)
	if error.is_empty():
		effects = ShotEffects.from_data(data.get("effects", {}))
		point_spread = ShotPointSpread.from_data(data.get("psf", {"sigma_px": psf_sigma_px}))
		headset = ShotHeadset.from_data(data.get("xr", false))
		disk = ShotDisk.from_data(data.get("disk"))
		_read_exposure(data.get("exposure", exposure_ev))
		_read_overlays(data.get("overlays", []))
		language = data.get("language", language)


func _read_path(data: Dictionary) -> void:
	sequence = ShotPath.from_data(data)
	error = sequence.error
	if not error.is_empty():
		return
	for frame in sequence.frame_count:
		go_to(frame)
		if not error.is_empty():
			return
	go_to(0)


func _read_pose(data: Dictionary) -> void:
	vertical_fov_deg = data.get("vertical_fov_deg", vertical_fov_deg)
	position = data.get("position_rs", position)
	_check_place()
	if error.is_empty():
		_read_observer(data)
	if error.is_empty():
		_read_aim(data)


func _check_place() -> void:
	var distance := Vec3D.length(position)
	if hole and distance < 1e-4:
		error = "position_rs lies in the singularity; keep at least 0.0001 away from the origin."
	elif distance > 1e12:
		error = "position_rs is farther than 1e12 Schwarzschild radii."


func _read_observer(data: Dictionary) -> void:
	observer = ShotObserver.from_data(data.get("observer", "static"), position, hole)
	error = observer.error


func _read_aim(data: Dictionary) -> void:
	var target: PackedFloat64Array = data.get("look_at_rs", [0.0, 0.0, 0.0])
	var upward: PackedFloat64Array = data.get("up", UPWARD)
	forward = Vec3D.subtract(target, position)
	# Radial motions leave the hole where it is, in double precision.
	if data.get("aim", "axes") == "apparent" and not observer.is_radial():
		forward = observer.apparent_hole(position)
	if Vec3D.length(forward) <= 1e-12 * Vec3D.length(position):
		error = "look_at_rs is the eye's own place; look somewhere else."
		return
	forward = Vec3D.normalized(forward)
	if Vec3D.length(upward) == 0.0 or Vec3D.sine(forward, upward) < 1e-9:
		if data.has("up"):
			error = "up points along the viewing direction; choose one across it."
			return
		upward = [0.0, 0.0, -1.0]
	up = Vec3D.normalized(Vec3D.cross(Vec3D.cross(forward, upward), forward))


func _read_stars(data: Dictionary) -> void:
	has_stars = data.get("stars", {}) != null
	if not has_stars:
		return
	var stars: Dictionary = data.get("stars", {})
	catalogue = stars.get("catalogue", catalogue)
	if catalogue != "builtin":
		catalogue = _find_file(catalogue, "stars.catalogue")
	magnitude_limit = stars.get("magnitude_limit", magnitude_limit)
	orders = stars.get("orders", orders)
	lensing = stars.get("lensing", lensing)
	psf_sigma_px = stars.get("psf_sigma_px", psf_sigma_px)
	exposure_ev = stars.get("exposure_ev", exposure_ev)


func _read_background(data: Dictionary) -> void:
	var source: String = data.get("background", "none")
	var known := BACKGROUNDS.find(source)
	background = Background.FILE if known < 0 else known as Background
	if background == Background.FILE:
		background_file = _find_file(source, "background")


func _read_exposure(value: Variant) -> void:
	auto_exposure = ShotAutoExposure.from_data(value)
	if auto_exposure == null:
		exposure_ev = value
	elif auto_exposure.min_ev > auto_exposure.max_ev:
		error = "exposure: min_ev lies above max_ev; swap them."


func _read_overlays(names: Array) -> void:
	for name: String in names:
		match name:
			"star_names":
				star_names = true
			"constellation_names":
				constellation_names = true
			_:
				overlays |= 1 << OVERLAYS.find(name)


func _find_file(path: String, key: String) -> String:
	var found := _files.find(path)
	if found.is_empty():
		error = "%s: there is no file %s." % [key, path]
	return found
