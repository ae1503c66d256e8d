# SPDX-License-Identifier: MIT
extends SceneTree
## Writes settings again and again, until it is killed. First says what the last run left.
##
## tools/testing/test_power_cut.py runs it in a small project of its own.


func _init() -> void:
	var settings := UserSettings.new()
	settings.file = OS.get_environment("SETTINGS_FILE")
	settings.reload()
	var volume := settings.get_number(&"volume")
	print("found %d %s" % [volume, "; ".join(settings.faults)])
	# In half of the runs each write keeps a former file, as after a minute's rest.
	var rested := OS.get_environment("RESTED") == "1"
	while true:
		volume = fmod(volume + 1.0, 101.0)
		print("begin %d" % volume)
		settings.set_value(&"volume", volume)
		if rested:
			DirAccess.remove_absolute(settings.file + AtomicFile.FORMER)
		settings.save()
		print("done %d" % volume)
