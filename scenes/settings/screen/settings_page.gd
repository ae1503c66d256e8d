# SPDX-License-Identifier: MIT
class_name SettingsPage
extends ScrollContainer
## One page of settings, a row for each; what has the focus is always in sight.

var page: StringName

var rows: VBoxContainer = VBoxContainer.new()

var _settings: UserSettings


func _init(of: StringName, settings: UserSettings) -> void:
	page = of
	_settings = settings
	horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	follow_focus = true
	var margin := MarginContainer.new()
	margin.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	# Room for the frame round what has the focus, and for the bar beside the page.
	for side: StringName in [&"margin_left", &"margin_top", &"margin_bottom"]:
		margin.add_theme_constant_override(side, 4)
	margin.add_theme_constant_override(&"margin_right", 18)
	add_child(margin)
	rows.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	rows.add_theme_constant_override(&"separation", 10)
	margin.add_child(rows)
	for setting in SettingList.of_page(page):
		if setting.kind != Setting.Kind.BINDINGS:
			rows.add_child(SettingRow.new(setting, settings))


## Adds a line that only tells something.
func add_words(text: String) -> Label:
	var label := Label.new()
	label.text = text
	label.theme_type_variation = &"Caption"
	label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	rows.add_child(label)
	return label


func get_first_focus() -> Control:
	for row in rows.get_children():
		if row is SettingRow:
			return (row as SettingRow).get_control()
	return null


## All as at first.
func reset() -> void:
	_settings.reset_page(page)
