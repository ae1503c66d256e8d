# SPDX-License-Identifier: MIT
class_name ExitStatus
extends RefCounted
## What the exhibit's exit statuses mean to whoever started it.

## The operator has ended it: it is not started again.
const OPERATOR: int = 0
## The headset's runtime has gone, or is not back yet: started again at once.
const RUNTIME_LOST: int = Supervision.LOST
const RUNTIME_MISSING: int = Supervision.STILL_WAITING
## The daily restart.
const DAILY: int = 77
## The program is not whole: a scene of it cannot be loaded.
const INCOMPLETE: int = 78
## The operator wants it started anew.
const RESTART: int = 79
## The supervisor is gone; there is nobody to read this.
const ORPHANED: int = 80
## Those after which it is started again at once.
const PLANNED: PackedInt32Array = [RUNTIME_LOST, RUNTIME_MISSING, DAILY, RESTART]


## An exit status in words, for logs; `operator`: the program said that the operator ended it.
static func describe(status: int, operator: bool) -> String:
	match status:
		OPERATOR:
			return "ended by the operator" if operator else "ended without being asked to"
		RUNTIME_LOST:
			return "the headset's runtime has gone"
		RUNTIME_MISSING:
			return "the headset's runtime is not there"
		DAILY:
			return "daily restart"
		INCOMPLETE:
			return "the program is incomplete"
		RESTART:
			return "restart by the operator"
		ORPHANED:
			return "its supervisor had gone"
	return "crashed or killed (exit status %d)" % status
