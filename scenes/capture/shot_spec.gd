# SPDX-License-Identifier: MIT
class_name ShotSpec
extends RefCounted
## One still to be taken: what is where, who looks, how it is drawn.
##
## Read from JSON and checked key by key: unknown keys, wrong types and impossible requests are
## refused by name. Positions are in Schwarzschild radii, hole at the origin, y to the north
## celestial pole.

enum Background { NONE, GRID, MILKY_WAY, FILE }

const RENDERERS: PackedStringArray = ["mobile", "forward_plus", "gl_compatibility"]
const PICTURE_FILES: PackedStringArray = ["png", "jpg", "jpeg", "exr", "hdr", "webp"]
const KEYS: PackedStringArray = [
	"resolution",
	"vertical_fov_deg",
	"position_rs",
	"look_at_rs",
	"aim",
	"up",
	"observer",
	"renderer",
	"stars",
	"background",
]
const STAR_KEYS: PackedStringArray = [
	"catalogue", "magnitude_limit", "orders", "lensing", "psf_sigma_px", "exposure_ev"
]

var resolution := Vector2i(1280, 720)
var vertical_fov_deg: float = 60.0
## Where the eye is, in double precision.
var position: PackedFloat64Array = [0.0, 0.0, 10.0]
## Viewing direction and the picture's upward direction, unit vectors, in double precision.
var forward: PackedFloat64Array = [0.0, 0.0, -1.0]
var up: PackedFloat64Array = [0.0, 1.0, 0.0]
var observer: LensingTable.Motion = LensingTable.MOTION_STATIC
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
var background: Background = Background.NONE
var background_file: String = ""
## Why the shot was refused; empty when it is fine.
var error: String = ""

var _folders: PackedStringArray = []


## Reads a shot from a file. Paths inside are looked up beside it, then in the `further_folder`.
static func from_file(path: String, further_folder: String = "") -> ShotSpec:
	var text := FileAccess.get_file_as_string(path)
	if text.is_empty():
		var refused := ShotSpec.new()
		refused.error = "Shot file %s is missing, unreadable or empty." % path
		return refused
	var parser := JSON.new()
	if parser.parse(text) != OK:
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
	spec._folders = folders
	if data is not Dictionary:
		spec.error = "A shot is a JSON object; this one is %s." % type_string(typeof(data))
		return spec
	spec._read(data)
	return spec


func _read(data: Dictionary) -> void:
	_refuse_unknown(data, KEYS, "")
	if not data.has("position_rs"):
		_refuse("position_rs is missing: say where the eye is, for example [0, 0, 10].")
	var size := _vector(data, "resolution", [1280.0, 720.0], 2)
	vertical_fov_deg = _number(data, "vertical_fov_deg", 60.0, 0.01, 179.0)
	position = _vector(data, "position_rs", [0.0, 0.0, 10.0], 3)
	observer = _choice(data, "observer", ["static", "rain"], 0) as LensingTable.Motion
	renderer = RENDERERS[_choice(data, "renderer", RENDERERS, 0)]
	renderer_named = data.has("renderer")
	if error.is_empty():
		_read_size(size)
	if error.is_empty():
		_read_place()
	if error.is_empty():
		_read_aim(data)
	if error.is_empty():
		_read_stars(data)
	if error.is_empty():
		_read_background(data)


func _read_size(size: PackedFloat64Array) -> void:
	resolution = Vector2i(roundi(size[0]), roundi(size[1]))
	if Vector2(resolution) != Vector2(size[0], size[1]) or mini(resolution.x, resolution.y) < 1:
		_refuse("resolution must be two whole numbers of pixels, at least 1.")
	elif maxi(resolution.x, resolution.y) > 8192:
		_refuse("resolution goes up to 8192 pixels a side.")


func _read_place() -> void:
	var distance := Vec3D.length(position)
	if distance < 1e-4:
		_refuse("position_rs lies in the singularity; keep at least 0.0001 away from the origin.")
	elif distance > 1e12:
		_refuse("position_rs is farther than 1e12 Schwarzschild radii.")
	elif observer == LensingTable.MOTION_STATIC and distance <= 1.0:
		_refuse(
			(
				'observer: no observer can be static at r = %s r_s, at or inside the horizon; choose "rain".'
				% String.num(distance)
			)
		)


func _read_aim(data: Dictionary) -> void:
	var apparent := _choice(data, "aim", ["axes", "apparent"], 0) == 1
	if apparent and data.has("look_at_rs"):
		_refuse('aim "apparent" centres the hole; leave look_at_rs out, or aim out.')
		return
	var target := _vector(data, "look_at_rs", [0.0, 0.0, 0.0], 3)
	var upward := _vector(data, "up", [0.0, 1.0, 0.0], 3)
	if not error.is_empty():
		return
	# For radial motions the hole is seen where it is: the boost is along the line of sight.
	forward = Vec3D.subtract(target, position)
	if Vec3D.length(forward) <= 1e-12 * Vec3D.length(position):
		_refuse("look_at_rs is the eye's own place; look somewhere else.")
		return
	forward = Vec3D.normalized(forward)
	if Vec3D.length(upward) == 0.0 or Vec3D.sine(forward, upward) < 1e-9:
		if data.has("up"):
			_refuse("up points along the viewing direction; choose one across it.")
			return
		upward = [0.0, 0.0, -1.0]
	up = Vec3D.normalized(Vec3D.cross(Vec3D.cross(forward, upward), forward))


func _read_stars(data: Dictionary) -> void:
	if not data.has("stars"):
		return
	if data["stars"] == null:
		has_stars = false
		return
	if data["stars"] is not Dictionary:
		_refuse("stars must be an object or null.")
		return
	var stars: Dictionary = data["stars"]
	_refuse_unknown(stars, STAR_KEYS, "stars.")
	if stars.has("catalogue") and stars["catalogue"] is not String:
		_refuse('stars.catalogue must be "builtin" or the path of a CSV or .stars file.')
		return
	catalogue = stars.get("catalogue", "builtin")
	if catalogue != "builtin":
		catalogue = _find_file(catalogue, "stars.catalogue")
	magnitude_limit = _number(stars, "magnitude_limit", 7.0, -30.0, 99.0, "stars.")
	var order_count := _number(stars, "orders", 2.0, 1.0, 4.0, "stars.")
	psf_sigma_px = _number(stars, "psf_sigma_px", 1.0, 0.3, 32.0, "stars.")
	exposure_ev = _number(stars, "exposure_ev", 0.0, -40.0, 60.0, "stars.")
	if order_count != roundf(order_count):
		_refuse("stars.orders must be a whole number, 1 to 4.")
	orders = roundi(order_count)
	if stars.has("lensing") and stars["lensing"] is not bool:
		_refuse("stars.lensing must be true or false.")
		return
	lensing = stars.get("lensing", true)


func _read_background(data: Dictionary) -> void:
	var value: Variant = data.get("background", "none")
	if value is not String:
		_refuse('background must be "none", "grid", "milky_way" or the path of a panorama.')
		return
	var source: String = value
	match source:
		"none":
			background = Background.NONE
		"grid":
			background = Background.GRID
		"milky_way":
			background = Background.MILKY_WAY
		_:
			background = Background.FILE
			if not PICTURE_FILES.has(source.get_extension().to_lower()):
				_refuse("background %s is neither a known background nor a picture file." % source)
				return
			background_file = _find_file(source, "background")


func _find_file(path: String, key: String) -> String:
	if path.is_absolute_path():
		if FileAccess.file_exists(path):
			return path
	else:
		for folder in _folders:
			var candidate := folder.path_join(path)
			if not folder.is_empty() and FileAccess.file_exists(candidate):
				return candidate
	_refuse("%s: there is no file %s." % [key, path])
	return path


func _refuse(reason: String) -> void:
	if error.is_empty():
		error = reason


func _refuse_unknown(data: Dictionary, known: PackedStringArray, prefix: String) -> void:
	for key: Variant in data:
		if not known.has(str(key)):
			_refuse("%s%s is no key of a shot; known: %s." % [prefix, key, ", ".join(known)])


func _number(
	data: Dictionary, key: String, fallback: float, low: float, high: float, prefix: String = ""
) -> float:
	var value: Variant = data.get(key, fallback)
	if value is not float and value is not int:
		_refuse("%s%s must be a number." % [prefix, key])
		return fallback
	var number: float = value
	if not is_finite(number) or number < low or number > high:
		_refuse("%s%s must lie between %s and %s." % [prefix, key, low, high])
		return fallback
	return number


func _vector(
	data: Dictionary, key: String, fallback: PackedFloat64Array, count: int
) -> PackedFloat64Array:
	if not data.has(key):
		return fallback
	var value: Variant = data[key]
	var items: Array = value if value is Array else []
	var numbers := PackedFloat64Array()
	for item: Variant in items:
		var number: float = item if item is float or item is int else NAN
		if is_finite(number):
			numbers.append(number)
	if items.size() != count or numbers.size() != count:
		_refuse("%s must be a list of %d numbers." % [key, count])
		return fallback
	return numbers


func _choice(data: Dictionary, key: String, choices: PackedStringArray, fallback: int) -> int:
	var value: Variant = data.get(key, choices[fallback])
	var chosen: String = value if value is String else ""
	if not choices.has(chosen):
		_refuse("%s must be one of: %s." % [key, ", ".join(choices)])
		return fallback
	return choices.find(chosen)
