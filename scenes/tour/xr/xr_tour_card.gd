# SPDX-License-Identifier: MIT
class_name XrTourCard
extends PanelSurface
## The captions of a tour on a card in the visitor's room, with buttons for hands and gazes. Child
## of the origin, so that it stays where it is while the visitor is carried.

const CAPTIONS: PackedScene = preload("res://scenes/tour/captions/tour_captions.tscn")
const THEME: Theme = preload("res://scenes/desktop/hud/hud_theme.tres")
## Seconds between two pictures of how far the tour is.
const REFRESH_SECONDS: float = 0.5

@export var guide: TourGuide
@export var head: Node3D
## How far before the head it stands.
@export_range(0.5, 5.0, 0.1, "suffix:m") var distance: float = 1.7
## So much lower than straight ahead: below what the tour shows.
@export_range(0.0, 60.0, 0.5, "suffix:°") var lower_degrees: float = 26.0

var captions: TourCaptions

var _since_refresh: float = 0.0


func _ready() -> void:
	super()
	picture.layers = 2  # for the visitor alone: those who stand around read the words below
	captions = CAPTIONS.instantiate()
	captions.guide = guide
	captions.theme = THEME
	captions.set_anchors_preset(Control.PRESET_FULL_RECT)
	captions.keys_shown = false
	captions.fade_seconds = 0.0
	captions.lines = 4
	captions.width = pixels.x
	captions.text_scale = 3.0
	captions.small_scale = 1.25
	show_content(captions)
	guide.caption_changed.connect(_on_caption_changed)
	guide.pause_changed.connect(_on_pause_changed)
	guide.station_begun.connect(_on_station_begun)
	visible = false
	set_process(false)


func _process(delta: float) -> void:
	_since_refresh += delta
	if _since_refresh >= REFRESH_SECONDS:
		_since_refresh = 0.0
		redraw()


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		redraw()


func distance_along(from: Vector3, direction: Vector3) -> float:
	return super(from, direction) if visible else INF


func _on_station_begun(_index: int) -> void:
	_stand_before_head()
	hold_back()


func _on_caption_changed(_words: String) -> void:
	visible = guide.is_on()
	set_process(visible)
	if not visible:
		leave()
	redraw()


func _on_pause_changed(_paused: bool) -> void:
	redraw()


# Turned to the eyes, in the direction in which they look, by the bearing alone.
func _stand_before_head() -> void:
	var room := get_parent_node_3d()
	var pose := room.global_transform.affine_inverse() * head.global_transform
	var back := XrRig.backwards(pose.basis)
	var lower := deg_to_rad(lower_degrees)
	var ahead := -back * cos(lower) + Vector3.DOWN * sin(lower)
	transform = Transform3D(Basis.looking_at(ahead, Vector3.UP), pose.origin + ahead * distance)
