# SPDX-License-Identifier: MIT
@tool
class_name TourCaption
extends Resource
## A sentence or two of a station, and what changes in the picture while they are read.

enum Look {
	AS_BEFORE,
	## At the hole.
	HOLE,
	## Away from it.
	AWAY,
	## Past it, square to the direction of the hole, which is then on the left.
	ALONG,
}

## Lines over the sky, by the bits of BlackHoleSky.overlays, for the inspector.
const LINES: String = (
	"Constellations:1,Equatorial grid:2,Galactic grid:4,Edge of the shadow:8,Einstein rings:16,"
	+ "Direction of motion:32,Diameter of the shadow:64,Without bending:128"
)
## Words that people read in a second, and seconds until their eyes have found the text.
const WORDS_PER_SECOND: float = 2.4
const SECONDS_TO_FIND: float = 1.8

## At most 25 words, in English; it is the key of the translations.
@export_multiline var text: String = ""
## What is said instead in a headset, where there is no telescope; empty: the same.
@export_multiline var headset_text: String = ""
## How long it stays where the tour goes on by itself; 0: as long as reading it takes.
@export_range(0.0, 120.0, 0.5, "suffix:s") var seconds: float = 0.0

@export_group("While it is read")
## The eye goes to this distance from the hole; on a ride the caption comes when the ride passes it.
## 0: as before.
@export_range(0.0, 1000.0, 0.01, "suffix:rₛ") var radius: float = 0.0
## The height of the picture becomes this angle; 0: as before.
@export_range(0.0, 120.0, 0.1, "suffix:°") var field_of_view: float = 0.0
## So many images of each star are drawn; 0: as before.
@export_range(0, 4) var image_orders: int = 0
## The exposure changes by so much from that of the station.
@export_range(-10.0, 10.0, 0.1, "suffix:EV") var exposure_change: float = 0.0
## The sky is shown as it is without the hole.
@export var without_hole: bool = false
## A ride goes by so many steps faster than the station says; each doubles the pace.
@export_range(-6, 4) var pace_change: int = 0
## Where the eye looks; AS_BEFORE: as at the caption before.
@export var look: Look = Look.AS_BEFORE
## Lines that are drawn besides those of the station.
@export_custom(PROPERTY_HINT_FLAGS, LINES) var more_lines: int = 0


## How long it stays, seconds.
func get_duration() -> float:
	if seconds > 0.0:
		return seconds
	return SECONDS_TO_FIND + count_words() / WORDS_PER_SECOND


func count_words() -> int:
	return text.split(" ", false).size()
