# SPDX-License-Identifier: MIT
class_name Sticks
extends RefCounted
## Reads the sticks of both hands as one, so that either hand alone can do everything.

enum Axis { X, Y }


## The stick that is pushed farthest along an axis, of the hands that count; nothing when none is.
static func strongest(hands: Array[XrHand], comfort: Comfort, axis: Axis) -> Vector2:
	var hand := strongest_hand(hands, comfort, axis)
	return hand.get_steer() if hand != null else Vector2.ZERO


## The hand whose stick that is; null when none is pushed.
static func strongest_hand(hands: Array[XrHand], comfort: Comfort, axis: Axis) -> XrHand:
	var found: XrHand = null
	var farthest := 0.0
	for hand in hands:
		if comfort != null and not comfort.counts(hand.tracker == &"left_hand"):
			continue
		var pushed := absf(hand.get_steer()[axis])
		if pushed > farthest:
			farthest = pushed
			found = hand
	return found
