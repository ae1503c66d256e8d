# SPDX-License-Identifier: MIT
class_name MenuBooth
extends Node3D
## The menu of a visit with all that it switches, a head, a hand and a pointer, without a headset.

const EYES := Vector3(0.4, 1.6, 0.2)

var sky := BlackHoleSky.new()
var disk := AccretionDisk.new()
var switches := SkySwitches.new()
var disk_switches := DiskSwitches.new()
var overlays := SkyOverlays.new()
var comfort := Comfort.new()
var pages := VisitPages.new()
var menu := XrMenu.new()
var head := Node3D.new()
var hand := FakeHand.new()
var pointer := XrPointer.new()
## What the other parts of a scene would tell; change it as you like.
var told: Dictionary[StringName, Variant] = {
	VisitPages.RINGS: true,
	VisitPages.CARDS: false,
	VisitPages.PASSTHROUGH: false,
	VisitPages.PAUSE_RIDE: false,
	VisitPages.SPECTATOR: "",
	VisitPages.OBSERVER: "",
}
var refused: Dictionary[StringName, String] = {}


func _init() -> void:
	sky.add_child(disk)
	switches.sky = sky
	disk_switches.disk = disk
	overlays.sky = sky
	pages.sky = sky
	pages.switches = switches
	pages.disk = disk_switches
	pages.overlays = overlays
	pages.comfort = comfort
	head.transform = Transform3D(Basis(Vector3.UP, 0.3), EYES)
	hand.tracker = &"right_hand"
	hand.position = EYES + Vector3(0.25, -0.3, -0.2)
	pointer.head = head
	pointer.hands = [hand]
	for node: Node in [sky, switches, disk_switches, overlays, comfort, pages, head, hand]:
		add_child(node)
	add_child(menu)
	add_child(pointer)


func _ready() -> void:
	pointer.set_process(false)
	for id in told:
		pages.states[id] = func() -> Variant: return told[id]
	for id: StringName in [VisitPages.FALL, VisitPages.LEAVE_RIDE, VisitPages.EXIT]:
		pages.refusals[id] = func() -> String: return refused.get(id, "")
	menu.set_pages(pages.make(), VisitPages.FIRST)


## Opens a page and waits until it is laid out.
func show_page(page: StringName) -> void:
	menu.open(head.global_transform)
	menu.go_to(page)
	await settle()


func settle() -> void:
	for frame in 3:
		await get_tree().process_frame


## The rows of the page that is shown, the one that leads back first.
func rows() -> Array[MenuRow]:
	return menu.sheet.get_rows()


## The middle of a row in the world.
func place_of(row: MenuRow) -> Vector3:
	var share := row.get_global_rect().get_center() / Vector2(menu.surface.pixels)
	var extent := menu.surface.picture.get_extent()
	var flat := (share - Vector2.ONE * 0.5) * extent * Vector2(1.0, -1.0)
	return menu.surface.to_global(Vector3(flat.x, flat.y, 0.0))


## Points there with the hand, and presses.
func press_at(place: Vector3) -> void:
	hand.here = true
	hand.aim_at(place)
	pointer.advance(0.02)
	hand.press()
	hand.release()


## Looks there for so long, in seconds.
func gaze_at(place: Vector3, seconds: float) -> void:
	hand.here = false
	head.look_at(place)
	for i in ceili(seconds / 0.05):
		pointer.advance(0.05)


## Looks away, so that the next look is a new one.
func look_away() -> void:
	head.look_at(head.global_position + menu.surface.global_basis.z)
	pointer.advance(0.05)
