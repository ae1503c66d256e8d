# SPDX-License-Identifier: MIT
class_name ShotStage
extends Node
## Sets up a shot in a viewport of its own and takes the picture.

const TABLE_FILE: String = "res://addons/blackhole_sky/data/schwarzschild.lut"
const CATALOGUE_FILE: String = "res://addons/blackhole_sky/data/hipparcos.stars"

## Farther than this from the hole the world is made smaller, to stay within what culling takes.
const LARGEST_DISTANCE: float = 1000.0
## The engine's perspective cameras go no narrower; a frustum given by its size does.
const NARROWEST_PERSPECTIVE_DEG: float = 1.0
## Frames drawn before the picture is taken: the engine compiles its pipelines in the first.
const WARM_UP_FRAMES: int = 3

var _viewport := SubViewport.new()
var _camera := Camera3D.new()
var _sky := BlackHoleSky.new()
var _disk := AccretionDisk.new()
var _labels := SkyLabels.new()
# Of shots for a headset; there once one is asked for.
var _xr: XrShot
var _catalogues: Dictionary[String, StarCatalogue] = {}


func _init() -> void:
	_viewport.own_world_3d = true
	# The Compatibility renderer draws in display values; there is no linear picture to keep.
	_viewport.use_hdr_2d = (RenderingServer.get_current_rendering_method() != "gl_compatibility")
	_sky.faint_limit = 1e-6
	# Exposures adapt in a film's time, not in that of its making.
	_sky.process_mode = Node.PROCESS_MODE_DISABLED
	_viewport.msaa_3d = Viewport.MSAA_DISABLED
	_viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	_camera.keep_aspect = Camera3D.KEEP_HEIGHT
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color.BLACK
	world.environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	_labels.sky = _sky
	_labels.camera = _camera
	_labels.visible = false
	_disk.visible = false
	_sky.add_child(_disk)
	for node: Node in [world, _camera, _sky, _labels]:
		_viewport.add_child(node)
	add_child(_viewport)


## Takes over what another sky has read already: the tables, the stars as the addon's catalogue, the
## constellations' lines.
func borrow(sky: BlackHoleSky) -> void:
	if sky.table != null and sky.table.is_ready():
		_sky.table = sky.table
	if sky.catalogue != null:
		_catalogues[CATALOGUE_FILE] = sky.catalogue
	_sky.figure_field = sky.figure_field


## Takes the picture: linear light (RGBAH) where the renderer keeps it, else 8-bit sRGB. Returns
## null, with a reason in `refusal`, when something the shot names cannot be had.
func take(spec: ShotSpec, refusal: PackedStringArray) -> Image:
	if not _dress(spec, refusal):
		return null
	_viewport.size = spec.resolution
	_place(spec)
	_sky.adapt_at_once()
	if spec.headset != null:
		return await _take_both_eyes(spec, refusal)
	return await _draw(WARM_UP_FRAMES)


## Takes the next picture of a sequence, whose first take() has taken: the same sky from elsewhere.
func take_next(spec: ShotSpec) -> Image:
	_place(spec)
	_sky.adapt(1.0 / spec.sequence.fps)
	if spec.headset != null:
		return await _xr.take(_camera.global_transform, _camera.far)
	return await _draw(1)


func _take_both_eyes(spec: ShotSpec, refusal: PackedStringArray) -> Image:
	if _xr == null:
		_xr = XrShot.new()
		add_child(_xr)
		var reason := await _xr.open(_viewport.find_world_3d())
		if not reason.is_empty():
			refusal.append(reason)
			return null
	_sky.stereo_baseline_scale = spec.headset.stereo_baseline_scale
	var picture := await _xr.take(_camera.global_transform, _camera.far)
	if picture == null:
		refusal.append("xr: the runtime gave no pictures.")
	return picture


func _place(spec: ShotSpec) -> void:
	# Stars not lensed are as for an eye at rest; one that has no hole may fly.
	_sky.observer = spec.observer.to_sky_observer() if spec.lensing else null
	if spec.disk != null:
		spec.disk.apply_to(_disk, spec.seconds)
	_aim(spec)


func _draw(frames: int) -> Image:
	for frame in frames:
		_viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
		await RenderingServer.frame_post_draw
	return _viewport.get_texture().get_image()


func _dress(spec: ShotSpec, refusal: PackedStringArray) -> bool:
	if _sky.table == null:
		var table := LensingTable.new()
		if table.load_file(TABLE_FILE) != OK:
			refusal.append(table.get_error_message())
			return false
		_sky.table = table
	_sky.stars_visible = spec.has_stars
	if spec.has_stars:
		var path := CATALOGUE_FILE if spec.catalogue == "builtin" else spec.catalogue
		if not _catalogues.has(path):
			var catalogue := StarCatalogue.new()
			if catalogue.load_file(path) != OK:
				refusal.append(catalogue.get_error_message())
				return false
			_catalogues[path] = catalogue
		if _sky.catalogue != _catalogues[path]:
			_sky.catalogue = _catalogues[path]
	_sky.magnitude_limit = spec.magnitude_limit
	_sky.image_orders = spec.orders
	_sky.lensing = 1.0 if spec.hole and spec.lensing else 0.0
	spec.point_spread.apply_to(_sky)
	if spec.auto_exposure != null:
		spec.auto_exposure.apply_to(_sky)
	else:
		_sky.auto_exposure = false
		_sky.exposure = spec.exposure_ev
	spec.effects.apply_to(_sky)
	_disk.visible = spec.disk != null
	if spec.disk != null:
		_sky.mass_solar = spec.disk.mass_solar
	_sky.projection = spec.projection
	_sky.overlays = spec.overlays
	_labels.visible = spec.star_names or spec.constellation_names
	_labels.stars_shown = spec.star_names
	_labels.constellations_shown = spec.constellation_names
	_labels.language = spec.language
	if spec.star_names and _labels.stars.names.is_empty():
		_labels.stars = StarNames.load_file()
		if not _labels.stars.error.is_empty():
			refusal.append(_labels.stars.error)
			return false
	return _set_constellations(spec, refusal) and _set_background(spec, refusal)


func _set_constellations(spec: ShotSpec, refusal: PackedStringArray) -> bool:
	var lines_wanted := spec.overlays & BlackHoleSky.OVERLAY_CONSTELLATIONS != 0
	if not (lines_wanted or spec.constellation_names):
		return true
	if _labels.figures.figures.is_empty():
		_labels.figures = ConstellationFigures.load_file()
	if not _labels.figures.error.is_empty():
		refusal.append(_labels.figures.error)
		return false
	if lines_wanted and _sky.figure_field == null:
		_sky.figure_field = ConstellationOverlay.bake(_labels.figures)
	return true


func _set_background(spec: ShotSpec, refusal: PackedStringArray) -> bool:
	match spec.background:
		ShotSpec.Background.NONE:
			_sky.background = BlackHoleSky.BACKGROUND_NONE
		ShotSpec.Background.GRID:
			_sky.background = BlackHoleSky.BACKGROUND_GRID
		ShotSpec.Background.MILKY_WAY:
			if not ResourceLoader.exists(MilkyWay.FILE):
				refusal.append("The Milky Way panorama %s is missing." % MilkyWay.FILE)
				return false
			_sky.panorama = load(MilkyWay.FILE) as Texture2D
			_sky.panorama_luminance = MilkyWay.LUMINANCE
			_sky.background = BlackHoleSky.BACKGROUND_PANORAMA
		ShotSpec.Background.FILE:
			var picture := BackgroundPicture.from_file(spec.background_file)
			if not picture.error.is_empty():
				refusal.append(picture.error)
				return false
			picture.image.generate_mipmaps()
			_sky.panorama = ImageTexture.create_from_image(picture.image)
			_sky.panorama_luminance = 1.0
			_sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	return true


func _aim(spec: ShotSpec) -> void:
	var wanted := spec.headset.schwarzschild_radius_m if spec.headset != null else 1.0
	var radius := minf(wanted, LARGEST_DISTANCE / Vec3D.length(spec.position))
	_sky.schwarzschild_radius = radius
	if spec.vertical_fov_deg >= NARROWEST_PERSPECTIVE_DEG:
		_camera.set_perspective(spec.vertical_fov_deg, _camera.near, _camera.far)
	else:
		var height := 2.0 * tan(deg_to_rad(0.5 * spec.vertical_fov_deg))
		_camera.set_frustum(height, Vector2.ZERO, 1.0, _camera.far)
	var right := Vec3D.cross(spec.forward, spec.up)
	_camera.transform = Transform3D(
		Vec3D.to_vector3(right),
		Vec3D.to_vector3(spec.up),
		-Vec3D.to_vector3(spec.forward),
		Vec3D.to_vector3(Vec3D.scaled(spec.position, radius))
	)
