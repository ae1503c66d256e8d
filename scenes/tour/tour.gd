# SPDX-License-Identifier: MIT
@tool
class_name Tour
extends Resource
## Stations that are shown one after the other, on a screen or in a headset.

## In English; it is the key of the translations.
@export var title: String = ""
@export var stations: Array[TourStation] = []


## What keeps it from being shown; empty: nothing.
func find_problem() -> String:
	if stations.is_empty():
		return "it has no stations"
	for i in stations.size():
		if stations[i] == null:
			return "station %d is empty" % (i + 1)
		var problem := stations[i].find_problem()
		if not problem.is_empty():
			return "station %d (%s): %s" % [i + 1, stations[i].title, problem]
	return ""
