# SPDX-License-Identifier: MIT
class_name DailyRestart
extends RefCounted
## Whether the program is to start anew, once a day at a set hour.


## `hour` of the day, -1: never; times are seconds of the local clock since 1970.
static func is_due(hour: int, started: float, now: float) -> bool:
	if hour < 0:
		return false
	var today := floorf(now / 86400.0) * 86400.0 + 3600.0 * hour
	return now >= today and started < today


## The local clock.
static func local_now() -> float:
	var bias: int = Time.get_time_zone_from_system()["bias"]
	return Time.get_unix_time_from_system() + 60.0 * bias
