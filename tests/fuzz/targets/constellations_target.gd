# SPDX-License-Identifier: MIT
extends FuzzTarget
## Constellation figures.


func _init() -> void:
	file_name = "constellations.json"
	is_json = true


func seeds() -> Array[PackedByteArray]:
	var all: Dictionary = JSON.parse_string(
		FileAccess.get_file_as_string(ConstellationFigures.FILE)
	)
	var rows: Array = all["constellations"]
	return [
		json({"constellations": rows.slice(0, 3)}),
		json({"constellations": rows.slice(40, 41), "remark": "any"}),
	]


func read(path: String) -> FuzzAnswer:
	var answer := FuzzAnswer.new()
	var loaded := ConstellationFigures.load_file(path)
	if not loaded.error.is_empty():
		answer.complain([loaded.error], path)
		answer.demand(loaded.figures.is_empty(), "no figures of a refused file")
		return answer
	answer.demand(not loaded.figures.is_empty(), "figures of an accepted file")
	for figure in loaded.figures:
		answer.demand(not figure.id.is_empty() and not figure.name("de").is_empty(), "names")
		answer.demand(not figure.labels.is_empty() and not figure.lines.is_empty(), "labels, lines")
		for place in figure.labels:
			answer.demand(absf(place.length() - 1.0) < 1e-5, "labels are directions")
		for line in figure.lines:
			answer.demand(line.size() >= 2, "a line has two ends")
			for place in line:
				answer.demand(absf(place.length() - 1.0) < 1e-5, "lines are of directions")
	return answer
