# SPDX-License-Identifier: MIT
class_name MapView
extends TextureRect
## A map of the whole sky as the eye sees it, with the hole in its middle. Dragging turns the stars
## against the hole.

## Render layer of the second sky, which only the map's camera sees.
const LAYER: int = 2
## What the second sky does not take over from the first.
const OWN: PackedStringArray = [
	"projection", "render_layers", "exposure", "auto_exposure", "panorama_luminance"
]
## A map's pixel is far larger than a picture's, and stars are fainter beside it by that; so many
## EV give them back, at no change of the background.
const STAR_GAIN: float = 1.5

var sky: BlackHoleSky
var disk: AccretionDisk
var controls: ViewControls
var labels: SkyLabels

var projection: BlackHoleSky.Projection = BlackHoleSky.PROJECTION_MOLLWEIDE

var _map_sky: BlackHoleSky
var _map_disk: MapDisk
var _shared := SharedProperties.new(&"BlackHoleSky", OWN)
var _dragging: bool = false

@onready var _viewport: SubViewport = %MapViewport
@onready var _camera: Camera3D = %MapCamera
@onready var _labels: SkyLabels = %MapLabels


func _ready() -> void:
	texture = _viewport.get_texture()
	_camera.cull_mask = LAYER
	# Compatibility stores display values whatever the buffer; 8 bits are what it shows.
	_viewport.use_hdr_2d = (RenderingServer.get_current_rendering_method() != "gl_compatibility")


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if click != null and click.button_index in [MOUSE_BUTTON_LEFT, MOUSE_BUTTON_RIGHT]:
		_dragging = click.pressed
		accept_event()
	elif motion != null and _dragging:
		turn_sky(motion.relative * radians_per_pixel(projection, size))
		accept_event()


## Shows the map; its sky is made for it.
func open() -> void:
	if _map_sky == null:
		_map_sky = BlackHoleSky.new()
		_map_sky.render_layers = LAYER
		_viewport.add_child(_map_sky)
		_map_disk = MapDisk.new(_map_sky)
		_labels.sky = _map_sky
	_viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	follow()


## Gives back what the map took.
func close() -> void:
	_dragging = false
	_viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	_labels.sky = null
	if _map_sky != null:
		_map_sky.queue_free()
		_map_sky = null
		_map_disk = null


## The sky of the map; null while it is closed.
func get_map_sky() -> BlackHoleSky:
	return _map_sky


## Takes over place, settings and names of the first picture.
func follow() -> void:
	if _map_sky == null:
		return
	var pixels := Vector2i(size * get_window().content_scale_factor).max(Vector2i(16, 16))
	if _viewport.size != pixels:
		_viewport.size = pixels
	_shared.copy(sky, _map_sky)
	_map_sky.exposure = sky.get_effective_exposure() + STAR_GAIN
	_map_sky.panorama_luminance = sky.panorama_luminance * pow(2.0, -STAR_GAIN)
	_map_sky.projection = projection
	if _map_sky.global_transform != sky.global_transform:
		_map_sky.global_transform = sky.global_transform
	_map_disk.follow(disk, STAR_GAIN)
	var eye := controls.rig.get_position() * sky.schwarzschild_radius
	_camera.transform = Transform3D(_axes(), eye)
	_labels.stars = labels.stars
	_labels.figures = labels.figures
	_labels.stars_shown = labels.stars_shown
	_labels.constellations_shown = labels.constellations_shown


## Turns the stars against the hole: by so many radians to the right and down on the map. The hole
## is round, so it is the eye that goes round it, and all vectors of the observer stay as they are.
func turn_sky(angles: Vector2) -> void:
	controls.revolve(_axes() * Vector3(angles.y, angles.x, 0.0))


## Angle per pixel in the middle of a map that fills `extent` pixels.
static func radians_per_pixel(kind: BlackHoleSky.Projection, extent: Vector2) -> float:
	var square := minf(extent.x, extent.y)
	match kind:
		BlackHoleSky.PROJECTION_FISHEYE_180:
			return PI / square
		BlackHoleSky.PROJECTION_FISHEYE_220:
			return deg_to_rad(220.0) / square
		BlackHoleSky.PROJECTION_FISHEYE_360, BlackHoleSky.PROJECTION_MERCATOR:
			return TAU / square
	return TAU / minf(extent.x, 2.0 * extent.y)


# Forward is the direction to the hole, up is up in the first picture.
func _axes() -> Basis:
	var inward := -controls.rig.get_position().normalized()
	var up := controls.rig.get_orientation() * Vector3.UP
	if absf(up.dot(inward)) > 0.9999:
		up = controls.rig.get_orientation() * Vector3.BACK
	return Basis.looking_at(inward, up)
