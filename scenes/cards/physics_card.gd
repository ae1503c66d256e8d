# SPDX-License-Identifier: MIT
class_name PhysicsCard
extends Resource
## What one effect is: a title, a few sentences, its formulas and what their signs mean. The texts
## are English and are translated where they are shown.

@export var title: String = ""
## At most 60 words.
@export_multiline var text: String = ""
## In the language of [FormulaParser].
@export var formulas: PackedStringArray = []
## The signs in the formulas.
@export_multiline var legend: String = ""
## What is said of the place where the eye is, one of [PlaceFigures]' names; empty: nothing.
@export var figure: StringName = &""
