# SPDX-License-Identifier: MIT
class_name BindingsPage
extends SettingsPage
## The page of the controls: how fast they are, and which key or button does what.

## What is to be told, for one line below the pages.
signal told(text: String)
## A cell was pressed: a binding is to be asked for.
signal asked(cell: BindingCell)

## Widths of the name and of a cell, in proportion.
const NAME_SHARE: float = 1.25

var _bindings := InputBindings.new()
var _cells: Array[BindingCell] = []
var _besides: Dictionary[StringName, String] = {}


func _init(settings: UserSettings) -> void:
	super(SettingList.CONTROLS, settings)
	rows.add_theme_constant_override(&"separation", 5)
	for row in ActionList.ROWS:
		var action: StringName = row[0]
		if row.size() == 1:
			_add_heading(String(action))
		elif InputMap.has_action(action):
			_besides[action] = row[3] if row.size() > 3 else ""
			_add_row(action)


func _ready() -> void:
	refresh()
	_settings.changed.connect(_on_changed)


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		refresh()


## Shows the present bindings.
func refresh() -> void:
	var changes: Dictionary = _settings.get_value(SettingList.BINDINGS)
	_bindings = InputBindings.from_json(changes, [])
	for cell in _cells:
		var mouse := cell.device == InputBindings.Device.MOUSE
		var events := _bindings.events_of(cell.action, cell.device)
		cell.display(events, _besides[cell.action] if mouse else "", _clashes(cell))
		cell.accessibility_name = "%s: %s" % [tr(ActionList.title_of(cell.action)), cell.words()]


## Gives the cell's action the event, unless that opens the menu.
func bind(cell: BindingCell, event: InputEvent) -> void:
	var words := BindingText.of(event)
	var shown := BindingNames.of_event(event)
	if InputBindings.is_reserved(words):
		told.emit(tr("%s opens the menu and keeps doing so.") % shown)
		return
	_bindings.bind(cell.action, event)
	_keep()
	var rivals := _bindings.rivals(cell.action, words)
	if not rivals.is_empty():
		var other := tr(ActionList.title_of(rivals[0]))
		told.emit(tr("%s is also that of: %s. One of the two needs another.") % [shown, other])


## Takes what is in the cell from its action.
func clear(cell: BindingCell) -> void:
	_bindings.clear(cell.action, cell.device)
	_keep()
	told.emit(tr("Taken away: %s") % tr(ActionList.title_of(cell.action)))


## Gives the cell's action back what it had at first.
func reset_action(cell: BindingCell) -> void:
	_bindings.reset(cell.action)
	_keep()
	told.emit(tr("As at first: %s") % tr(ActionList.title_of(cell.action)))


func _keep() -> void:
	_settings.set_value(SettingList.BINDINGS, _bindings.to_json())


func _clashes(cell: BindingCell) -> bool:
	for words in _bindings.words_of(cell.action):
		if InputBindings.device_of(words) == cell.device:
			if not _bindings.rivals(cell.action, words).is_empty():
				return true
	return false


func _add_heading(title: String) -> void:
	rows.add_child(HSeparator.new())
	var line := _add_line(title)
	for text: String in ["Keyboard", "Mouse", "Gamepad"]:
		var label := Label.new()
		label.text = text
		label.theme_type_variation = &"Caption"
		label.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
		label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		line.add_child(label)


func _add_row(action: StringName) -> void:
	var line := _add_line(ActionList.title_of(action))
	for device: InputBindings.Device in InputBindings.Device.values():
		var cell := BindingCell.new(action, device)
		cell.pressed.connect(asked.emit.bind(cell))
		_cells.append(cell)
		line.add_child(cell)


func _add_line(title: String) -> HBoxContainer:
	var line := HBoxContainer.new()
	line.add_theme_constant_override(&"separation", 12)
	var name_label := Label.new()
	name_label.text = title
	name_label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	name_label.size_flags_stretch_ratio = NAME_SHARE
	name_label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	line.add_child(name_label)
	rows.add_child(line)
	return line


func _on_changed(key: StringName) -> void:
	if key == SettingList.BINDINGS:
		refresh()
