# SPDX-License-Identifier: MIT
class_name VisitWishes
extends Node
## Does what the menu asks of the parts of a visit, and tells the menu how they stand.

## So much higher or lower with each wish, metres.
const LIFT: float = 0.1

@export var pages: VisitPages
@export var scene: XrScene
@export var rig: XrRig
@export var rides: XrRides
@export var spectator: Spectator
@export var choice: ObserverChoice
@export var passthrough: Passthrough
@export var tour: TourGuide
@export var credits: RollingCredits


func _ready() -> void:
	pages.asked.connect(_on_asked)
	pages.states = {
		VisitPages.RINGS: func() -> bool: return scene.rings_shown,
		VisitPages.PAUSE_RIDE: rides.is_paused,
		VisitPages.CARDS: func() -> bool: return scene.cards_shown,
		VisitPages.SPECTATOR: _spectator_title,
		VisitPages.OBSERVER: func() -> String: return ObserverKind.title(choice.get_kind()),
		VisitPages.PASSTHROUGH: passthrough.is_on,
	}
	pages.refusals = {
		VisitPages.RINGS: _refuse_when_carried,
		VisitPages.CARDS: _refuse_on_tour,
		VisitPages.FALL: _refuse_when_carried,
		VisitPages.ORBIT_RIGHT: _refuse_when_carried,
		VisitPages.ORBIT_LEFT: _refuse_when_carried,
		VisitPages.HIGHER: _refuse_when_carried,
		VisitPages.LOWER: _refuse_when_carried,
		VisitPages.OBSERVER: _refuse_when_carried,
		VisitPages.PAUSE_RIDE: _refuse_without_ride,
		VisitPages.LEAVE_RIDE: _refuse_without_ride,
		VisitPages.PASSTHROUGH: passthrough.why_not,
		VisitPages.TOUR_START: _refuse_when_carried,
		VisitPages.TOUR_NEXT: _refuse_without_tour,
		VisitPages.TOUR_PREVIOUS: _refuse_without_tour,
		VisitPages.TOUR_LEAVE: _refuse_without_tour,
	}


func _process(_delta: float) -> void:
	if scene.has_started() and not rides.is_on():
		choice.watch(rig.get_place() / scene.sky.schwarzschild_radius)


func _on_asked(id: StringName) -> void:
	match id:
		VisitPages.FALL:
			rides.start(XrRides.Kind.FALL)
		VisitPages.ORBIT_RIGHT:
			rides.start(XrRides.Kind.ORBIT_RIGHT)
		VisitPages.ORBIT_LEFT:
			rides.start(XrRides.Kind.ORBIT_LEFT)
		VisitPages.PAUSE_RIDE:
			rides.toggle_pause()
		VisitPages.LEAVE_RIDE:
			rides.leave()
		VisitPages.RECENTRE:
			scene.recentre()
		VisitPages.HIGHER:
			rig.lift(LIFT)
		VisitPages.LOWER:
			rig.lift(-LIFT)
		VisitPages.RINGS:
			scene.rings_shown = not scene.rings_shown
		VisitPages.CARDS:
			scene.cards_shown = not scene.cards_shown
		VisitPages.SPECTATOR:
			spectator.mode = (spectator.mode + 1) % Spectator.Mode.size() as Spectator.Mode
		VisitPages.OBSERVER:
			choice.choose_next(rig.get_place() / scene.sky.schwarzschild_radius, Vector3.UP)
		VisitPages.PASSTHROUGH:
			passthrough.set_on(not passthrough.is_on())
		VisitPages.TOUR_START:
			tour.begin()
		VisitPages.TOUR_NEXT:
			tour.next_station()
		VisitPages.TOUR_PREVIOUS:
			tour.previous_station()
		VisitPages.TOUR_LEAVE:
			tour.leave()
		VisitPages.CREDITS:
			credits.toggle()
		VisitPages.EXIT:
			scene.leave()


func _refuse_when_carried() -> String:
	return tr("End the ride first.") if rides.is_on() else _refuse_on_tour()


func _refuse_on_tour() -> String:
	return tr("End the tour first.") if tour.is_on() else ""


func _refuse_without_tour() -> String:
	return "" if tour.is_on() else tr("There is no tour now.")


func _refuse_without_ride() -> String:
	return "" if rides.is_on() else tr("There is no ride now.")


func _spectator_title() -> String:
	match spectator.mode:
		Spectator.Mode.VIEW:
			return tr("View")
		Spectator.Mode.BOTH_EYES:
			return tr("Both eyes")
	return tr("Nothing")
