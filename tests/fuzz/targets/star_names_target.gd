# SPDX-License-Identifier: MIT
extends FuzzTarget
## The table of star names.


func _init() -> void:
	file_name = "names.csv"
	words = ["hip,name,ra_deg,dec_deg,vmag\n", '"', '""', ",", "\n", "\r\n", "32349,Sirius,"]


func seeds() -> Array[PackedByteArray]:
	var lines := FileAccess.get_file_as_string(StarNames.FILE).split("\n")
	return [
		"\n".join(lines.slice(0, 5)).to_utf8_buffer(),
		(lines[0] + '\n1,"a ""b"", c",359.9,-90,-1.5\n').to_utf8_buffer(),
	]


func read(path: String) -> FuzzAnswer:
	var answer := FuzzAnswer.new()
	var loaded := StarNames.load_file(path)
	var count := loaded.names.size()
	answer.demand(
		loaded.hips.size() == count and loaded.directions.size() == count, "lists of one length"
	)
	answer.demand(loaded.magnitudes.size() == count, "as many magnitudes")
	if not loaded.error.is_empty():
		answer.complain([loaded.error], path)
		answer.demand(count == 0, "no names of a refused file")
		return answer
	answer.demand(count > 0, "names of an accepted file")
	for i in count:
		answer.demand(loaded.hips[i] > 0 and not loaded.names[i].is_empty(), "number and name")
		answer.demand(absf(loaded.directions[i].length() - 1.0) < 1e-5, "a direction")
		answer.demand(absf(loaded.magnitudes[i]) <= 50.0, "a magnitude")
	return answer
