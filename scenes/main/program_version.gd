# SPDX-License-Identifier: MIT
class_name ProgramVersion
extends RefCounted
## The program's version: that of the addon it is made with.

const FILE: String = "res://addons/blackhole_sky/plugin.cfg"


## Empty when the addon's file is not there.
static func text() -> String:
	var plugin := ConfigFile.new()
	if plugin.load(FILE) != OK:
		return ""
	var version: String = plugin.get_value("plugin", "version", "")
	return version
