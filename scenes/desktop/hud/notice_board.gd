# SPDX-License-Identifier: MIT
class_name NoticeBoard
extends VBoxContainer
## Shows short messages at the top of the picture, each for a while or until it is taken down.

const FADE_SECONDS: float = 0.4
const SHOWN_SECONDS: float = 6.0

var _notices: Dictionary[StringName, PanelContainer] = {}


## Shows `text`; a text on the same topic that is still up is replaced. 0 seconds: until taken down.
func post(topic: StringName, text: String, seconds: float = SHOWN_SECONDS) -> void:
	if _notices.has(topic):
		_notices[topic].queue_free()
	var notice := _make(text)
	_notices[topic] = notice
	add_child(notice)
	if seconds > 0.0:
		var tween := notice.create_tween()
		tween.tween_interval(seconds)
		tween.tween_callback(take_down.bind(topic))


## Lets the message on a topic fade away, if there is one.
func take_down(topic: StringName) -> void:
	if not _notices.has(topic):
		return
	var notice := _notices[topic]
	_notices.erase(topic)
	var tween := notice.create_tween()
	tween.tween_property(notice, ^"modulate:a", 0.0, FADE_SECONDS)
	tween.tween_callback(notice.queue_free)


## The text that is up on a topic; empty when there is none.
func get_text(topic: StringName) -> String:
	return (_notices[topic].get_child(0) as Label).text if _notices.has(topic) else ""


func _make(text: String) -> PanelContainer:
	var label := Label.new()
	label.text = text
	label.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	label.custom_minimum_size.x = 460.0
	var panel := PanelContainer.new()
	panel.theme_type_variation = &"NoticePanel"
	panel.mouse_filter = Control.MOUSE_FILTER_IGNORE
	panel.size_flags_horizontal = Control.SIZE_SHRINK_CENTER
	panel.add_child(label)
	return panel
