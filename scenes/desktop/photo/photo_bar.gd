# SPDX-License-Identifier: MIT
class_name PhotoBar
extends PanelContainer
## The photo mode's bar: exposure, field of view, roll, what a star's light spreads into, size and
## the buttons. What it sets is seen at once.

signal save_asked(kind: String)
signal thirds_toggled(shown: bool)
signal done

## Seconds between two updates.
const INTERVAL: float = 0.1
## Rows of the pictures to choose from; 0: those of the window. All have the window's shape.
const HEIGHTS: PackedInt32Array = [0, 1080, 2160]
const LARGEST: int = 8192
## How far the outline of the slider that has the focus stands off, pixels.
const OUTLINE: float = 5.0
## Diameters in millimetres of the apertures to choose from.
const APERTURES: PackedFloat64Array = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0]

var sky: BlackHoleSky
var camera: Camera3D
var controls: ViewControls

var _elapsed: float = 0.0

@onready var _exposure: ValueSlider = %Exposure
@onready var _fov: ValueSlider = %FieldOfView
@onready var _roll: ValueSlider = %Roll
@onready var _stars: Stepper = %Stars
@onready var _size: Stepper = %Size
@onready var _thirds: CheckBox = %Thirds
@onready var _png: Button = %SavePng
@onready var _exr: Button = %SaveExr
@onready var _done: Button = %Done
@onready var _hint: Label = %BarHint


func _ready() -> void:
	_exposure.value_changed.connect(func(to: float) -> void: sky.exposure = to)
	_fov.value_changed.connect(func(to: float) -> void: camera.fov = to)
	_roll.value_changed.connect(_on_roll_changed)
	_stars.chosen.connect(_on_stars_chosen)
	_thirds.toggled.connect(thirds_toggled.emit)
	_png.pressed.connect(save_asked.emit.bind("png"))
	_exr.pressed.connect(save_asked.emit.bind("exr"))
	_done.pressed.connect(done.emit)
	_chain_focus()


# Sliders do not show the focus plainly enough.
func _draw() -> void:
	var focused := get_viewport().gui_get_focus_owner() as ValueSlider
	if focused != null and is_ancestor_of(focused):
		var outline := Rect2(focused.global_position - global_position, focused.size)
		draw_style_box(get_theme_stylebox(&"focus", &"Button"), outline.grow(OUTLINE))


func _process(delta: float) -> void:
	_elapsed += delta
	if visible and _elapsed >= INTERVAL:
		refresh()


func get_first_focus() -> Control:
	return _exposure


## In pixels.
func get_resolution() -> Vector2i:
	return resolution(HEIGHTS[_size.at], get_window().size)


## The size of a picture of `rows`, 0 for the window's, that has the shape of a `window`.
static func resolution(rows: int, window: Vector2i) -> Vector2i:
	if rows == 0:
		return window.clampi(1, LARGEST)
	return Vector2i(clampi(roundi(float(rows) * window.x / maxi(window.y, 1)), 1, LARGEST), rows)


func refresh() -> void:
	_elapsed = 0.0
	_exposure.display(sky.exposure, ReadoutText.exposure(sky.exposure))
	_fov.display(camera.fov, "%.1f°" % camera.fov)
	var roll := CameraRoll.of(_axes())
	_roll.display(roll, "%.1f°" % roll)
	var titles := PackedStringArray([PicturePage.spread_titles(0.0)[0]])
	for aperture in APERTURES:
		titles.append(PicturePage.spread_titles(aperture)[1])
	titles.append(PicturePage.spread_titles(0.0)[2])
	_stars.titles = titles
	_stars.at = _spread_at()
	_size.titles = _size_titles()
	var key := BindingNames.keyboard([PhotoMode.BAR_ACTION])
	var button := BindingNames.gamepad([PhotoMode.BAR_ACTION])
	_hint.text = tr("%s or %s hides the bar: then keys and sticks move the camera.") % [key, button]


# One after the other by up and down alone, as sliders and steppers take left and right.
func _chain_focus() -> void:
	var chain: Array[Control] = [_exposure, _fov, _roll, _stars, _size, _thirds, _png, _exr, _done]
	FocusRing.link(chain)
	for control in chain:
		control.focus_entered.connect(queue_redraw)
		control.focus_exited.connect(queue_redraw)
		control.item_rect_changed.connect(queue_redraw)


func _axes() -> Basis:
	return sky.global_basis.orthonormalized().inverse() * camera.global_basis


func _size_titles() -> PackedStringArray:
	var titles := PackedStringArray()
	for rows in HEIGHTS:
		var extent := resolution(rows, get_window().size)
		var text := "%d × %d" % [extent.x, extent.y]
		titles.append(tr("Window, %s") % text if rows == 0 else text)
	return titles


func _spread_at() -> int:
	match sky.psf_model:
		BlackHoleSky.PSF_GAUSSIAN:
			return 0
		BlackHoleSky.PSF_EYE:
			return APERTURES.size() + 1
	var nearest := 0
	for i in APERTURES.size():
		var change := absf(APERTURES[i] - sky.aperture_mm)
		if change < absf(APERTURES[nearest] - sky.aperture_mm):
			nearest = i
	return nearest + 1


func _on_stars_chosen(at: int) -> void:
	if at == 0:
		sky.psf_model = BlackHoleSky.PSF_GAUSSIAN
	elif at > APERTURES.size():
		sky.psf_model = BlackHoleSky.PSF_EYE
	else:
		sky.psf_model = BlackHoleSky.PSF_AIRY
		sky.aperture_mm = APERTURES[at - 1]


func _on_roll_changed(to: float) -> void:
	controls.rig.turn(0.0, 0.0, deg_to_rad(to - CameraRoll.of(_axes())))
	controls.advance(0.0)
