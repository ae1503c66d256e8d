# SPDX-License-Identifier: MIT
class_name Supervision
extends RefCounted
## How the program asks whoever started it to start it again, since the engine finds a headset's
## runtime only when it starts.

## Ends with this status: the runtime has gone.
const LOST: int = 75
## And with this one: it has not come back yet.
const STILL_WAITING: int = 76
## Set to 1 by those who know of these.
const VARIABLE: String = "BLACKHOLE_SUPERVISED"
## Set to 1 when they start the program again.
const AGAIN_VARIABLE: String = "BLACKHOLE_STARTED_AGAIN"


static func is_supervised() -> bool:
	return OS.get_environment(VARIABLE) == "1"


## Was there a headset before?
static func is_started_again() -> bool:
	return OS.get_environment(AGAIN_VARIABLE) == "1"
