# SPDX-License-Identifier: MIT
class_name TourFile
extends RefCounted
## Reads a tour, or says which file is amiss and what to do.

## The tour; null when there is none.
var tour: Tour
## Why there is none; empty when all is well.
var error: String = ""


static func read(path: String) -> TourFile:
	var file := new()
	if not ResourceLoader.exists(path):
		file.error = "%s is missing. Put the tour there, or choose another file." % path
		return file
	file.tour = ResourceLoader.load(path) as Tour
	if file.tour == null:
		file.error = "%s holds no tour. Restore the file, or make a new Tour resource there." % path
		return file
	var problem := file.tour.find_problem()
	if not problem.is_empty():
		file.error = "%s cannot be shown: %s. Open it in the editor and mend it." % [path, problem]
		file.tour = null
	return file
