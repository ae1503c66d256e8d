# SPDX-License-Identifier: MIT
class_name PhysicsCardSet
extends Resource
## Cards in the order in which they are listed.

@export var cards: Array[PhysicsCard] = []
