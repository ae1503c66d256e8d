# SPDX-License-Identifier: MIT
extends XrTestCase
## The guided tour in the headset: its card is there at every station (the first few; all with
## ./test --all), and afterwards the visitor is where they were.

## Fainter stars make no difference to what is tested, but processors draw them slowly.
const FAINTEST: float = 3.0
const EYES := Vector3(0.0, 1.6, 0.0)
const FEW: int = 4


func test_the_tour_is_shown_station_by_station_and_left() -> void:
	if not await begun():
		return
	var scene := visit.scene
	var card: XrTourCard = scene.get_node("Headset/Origin/TourCard")
	await move_head(Transform3D(Basis.IDENTITY, EYES))
	var room := scene.rig.get_room()
	var radius := scene.sky.schwarzschild_radius
	scene.sky.magnitude_limit = FAINTEST
	scene.tour.automatic = false
	assert_true(scene.tour.begin())
	assert_true(card.visible, "the card")
	var shown: int = scene.spectator.cull_mask & card.picture.layers
	assert_eq(shown, 0, "the spectators read the words below, not the card")
	var all := RendererScope.is_everything_wanted()
	for i in scene.tour.tour.stations.size() if all else FEW:
		if i > 0:
			scene.tour.next_station()
		assert_true(await visit.settle(scene.tour.stage.is_arrived), "station %d" % (i + 1))
		var station := scene.tour.get_station()
		assert_almost_eq(scene.rig.get_radius() / station.radius, 1.0, 0.1, station.title)
		assert_string_contains(scene.spectator.get_caption(), scene.tour.get_words())
	scene.tour.leave()
	assert_false(card.visible)
	assert_almost_eq(scene.sky.schwarzschild_radius, radius, 1e-6)
	assert_true(scene.rig.get_room().is_equal_approx(room))


func test_the_menu_starts_it_and_a_lost_focus_pauses_it() -> void:
	if not await begun():
		return
	var scene := visit.scene
	await move_head(Transform3D(Basis.IDENTITY, EYES))
	scene.get_node("Pages").asked.emit(VisitPages.TOUR_START)
	assert_true(scene.tour.is_on())
	assert_ne(scene.get_node("Pages").refusals[VisitPages.FALL].call(), "")
	scene.session.focus_changed.emit(false)
	assert_true(scene.tour.is_paused())
	scene.session.focus_changed.emit(true)
	scene.get_node("Pages").asked.emit(VisitPages.TOUR_LEAVE)
	assert_false(scene.tour.is_on())
	assert_eq(scene.get_node("Pages").refusals[VisitPages.FALL].call(), "")
