# SPDX-License-Identifier: MIT
class_name ComfortPage
extends RefCounted
## What makes a visit comfortable, as lines of the menu.

## Distances of the eyes to choose from, in parts of the truth.
const BASELINES: PackedFloat32Array = [0.1, 0.25, 0.5, 1.0]

var comfort: Comfort


func _init(of: Comfort) -> void:
	comfort = of


func items() -> Array[MenuItem]:
	return [
		MenuItem.choice(&"preset", _translated("Preset"), _preset_title, _next_preset),
		MenuItem.choice(&"turning", _translated("Turning"), _turning_title, _toggle_turning),
		MenuItem.toggle(&"flying", _translated("Flying"), _flies, _toggle_flying),
		MenuItem.toggle(&"tunnel", _translated("Tunnel view"), _has_tunnel, _toggle_tunnel),
		MenuItem.toggle(&"frame", _translated("Room frame"), _has_frame, _toggle_frame),
		MenuItem.choice(&"hands", _translated("Hands"), _hands_title, _next_hands),
		MenuItem.choice(&"depth", _translated("Depth"), _depth_title, _next_depth),
	]


## Does everything stand as its preset has it?
func is_as_preset() -> bool:
	var values: Dictionary = Comfort.VALUES[comfort.preset]
	for property: String in values:
		if comfort.get(property) != values[property]:
			return false
	return true


func _preset_title() -> String:
	if not is_as_preset():
		return tr("Your own")
	return tr("Comfortable") if comfort.preset == Comfort.Preset.COMFORT else tr("Free")


# From one's own back to the preset that one began with.
func _next_preset() -> void:
	var presets := Comfort.Preset.size()
	var next := (comfort.preset + 1) % presets if is_as_preset() else comfort.preset
	comfort.preset = next as Comfort.Preset


func _turning_title() -> String:
	return tr("gliding") if comfort.smooth_turn else tr("in steps")


func _toggle_turning() -> void:
	comfort.smooth_turn = not comfort.smooth_turn


func _flies() -> bool:
	return comfort.smooth_flight


func _toggle_flying() -> void:
	comfort.smooth_flight = not comfort.smooth_flight


func _has_tunnel() -> bool:
	return comfort.vignette > 0.0


func _toggle_tunnel() -> void:
	var full: float = Comfort.VALUES[Comfort.Preset.COMFORT]["vignette"]
	comfort.vignette = 0.0 if _has_tunnel() else full


func _has_frame() -> bool:
	return comfort.fixed_frame


func _toggle_frame() -> void:
	comfort.fixed_frame = not comfort.fixed_frame


func _hands_title() -> String:
	match comfort.hands:
		Comfort.Hands.LEFT:
			return tr("left")
		Comfort.Hands.RIGHT:
			return tr("right")
	return tr("both")


func _next_hands() -> void:
	comfort.hands = (comfort.hands + 1) % Comfort.Hands.size() as Comfort.Hands


func _depth_title() -> String:
	return "%d %%" % roundi(100.0 * comfort.stereo_baseline)


func _next_depth() -> void:
	for baseline in BASELINES:
		if baseline > comfort.stereo_baseline + 1e-3:
			comfort.stereo_baseline = baseline
			return
	comfort.stereo_baseline = BASELINES[0]


# Marks a text to be translated when it is shown.
static func _translated(text: String) -> String:
	return text
