# SPDX-License-Identifier: MIT
@abstract class_name PathCourse
extends RefCounted
## Where the eye is in each frame of a sequence, and how it moves there.

## Why the course was refused; empty when it is fine.
var error: String = ""

## The keys of a shot that change from frame to frame, with their values in this one.
@abstract func pose(frame: int) -> Dictionary
