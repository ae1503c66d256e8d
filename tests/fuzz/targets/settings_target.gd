# SPDX-License-Identifier: MIT
extends FuzzTarget
## The user's settings. What is wrong is told and left out; what is taken over, the settings take.

const ASIDE: String = "settings.damaged.json"


func _init() -> void:
	file_name = "settings.json"
	is_json = true


func seeds() -> Array[PackedByteArray]:
	var values := {}
	for key in SettingList.keys():
		values[String(key)] = SettingList.find(key).initial
	var bound := {"bindings": {"fly_forward": ["key:F"], "move_forward": ["pad:0", "axis:1-"]}}
	for action in ActionList.actions():
		bound["bindings"][String(action)] = Array(InputBindings.given(action))
	return [
		json(values),
		json(bound),
		json({"language": "de", "mute": true, "volume": 35}),
		json({"bindings": {"nothing": ["key:Nokey", "mouse:99", "pad:-1"]}}),
	]


func read(path: String) -> FuzzAnswer:
	var answer := FuzzAnswer.new()
	var faults: Array[String] = []
	var values := SettingsFile.read(path, faults)
	DirAccess.remove_absolute(path.get_base_dir().path_join(ASIDE))
	var shown := ProjectSettings.globalize_path(path)
	answer.complain(PackedStringArray(faults), shown)
	for key in values:
		var setting := SettingList.find(key)
		answer.demand(setting != null and setting.takes(values[key]), "%s takes its value" % key)
	var bindings: Dictionary = values.get(SettingList.BINDINGS, {})
	var amiss: Array[String] = []
	var again := InputBindings.from_json(bindings, amiss)
	answer.demand(amiss.is_empty(), "bindings that were taken are fine: " + " ".join(amiss))
	answer.demand(JsonKinds.same(again.to_json(), bindings), "bindings come back the same")
	return answer
