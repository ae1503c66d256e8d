# SPDX-License-Identifier: MIT
extends XrTestCase
## A long visit in which everything is used: walking, turning, jumps, menu, cards, rides, hands that
## come and go. Nothing is printed as an error, and memory stays where it was after the first round.
## 600 frames; 10,000 with ./test --all.

const FEW: int = 600
const MANY: int = 10000
## Frames of one round through all that there is.
const ROUND: int = 100
## Memory may grow by so much after the warm-up, MB.
const GROWTH_MB: float = 2.0
## Fainter stars make no difference to what is tested, but processors draw them slowly.
const FAINTEST: float = 3.0

var _frame: int = 0


func test_a_long_visit() -> void:
	if not await begun():
		return
	var scene := visit.scene
	scene.sky.magnitude_limit = FAINTEST
	scene.sky.background = BlackHoleSky.BACKGROUND_NONE
	scene.spectator.mode = Spectator.Mode.VIEW
	scene.spectator.most_rows = 120
	var frames := MANY if RendererScope.is_everything_wanted() else FEW
	var warm_up := ROUND if frames == FEW else 12 * ROUND
	var rides := [0]
	scene.rides.began.connect(func() -> void: rides[0] += 1)
	var errors := get_errors().size()
	var start_mb := 0.0
	while _frame < frames:
		_act(_frame % ROUND, floori(float(_frame) / ROUND))
		visit.headset.send()
		await get_tree().process_frame
		_frame += 1
		if _frame == warm_up:
			start_mb = _memory_mb()
			gut.p("after the warm-up: %.1f MB" % start_mb)
	# At the same point of a round as at the end of the warm-up.
	var grown := _memory_mb() - start_mb
	gut.p("%d frames, %d rides, memory grew by %.2f MB" % [_frame, rides[0], grown])
	assert_lt(grown, GROWTH_MB, "memory")
	XrVisit.excuse(get_errors())
	for i in range(errors, get_errors().size()):
		var error: GutTrackedError = get_errors()[i]
		if not error.handled:
			fail_test("printed: %s" % error)
	assert_gt(int(rides[0]), 1, "rides were ridden")
	assert_eq(scene.session.state, XrSession.State.FOCUSED)


# What is done in a frame of a round.
func _act(frame: int, number: int) -> void:
	var scene := visit.scene
	var headset := visit.headset
	var sway := Vector3(0.1 * sin(0.13 * _frame), 1.6 + 0.03 * sin(0.21 * _frame), 0.1)
	headset.head = Transform3D(Basis(Vector3.UP, 0.4 * sin(0.05 * _frame)), sway)
	match frame:
		1:
			scene.recentre()
			scene.comfort.preset = (number % 2) as Comfort.Preset
		2:
			headset.right.stick = Vector2(1.0, 0.0)
		6:
			headset.right.stick = Vector2(0.0, -1.0)
			headset.right.grip = 1.0
		12:
			headset.right.stick = Vector2.ZERO
			scene.rings_shown = true
		15:
			scene.jump.jump(4.0, 0.1 * number)
		17:
			scene.rings_shown = false
			scene.cards_shown = true
			scene.cards.open(number % 3)
		22:
			scene.cards_shown = false
			headset.left.button_b = true
		25:
			headset.left.button_b = false
			scene.menu.open(scene.head.global_transform)
		27:
			scene.menu.go_to(VisitPages.SKY)
		30:
			scene.menu.close()
			headset.right.active = false
		33:
			headset.right.active = true
			TranslationServer.set_locale("de" if number % 2 == 0 else "en")
		35:
			scene.rides.countdown_seconds = 0
			scene.rides.start((number % 3) as XrRides.Kind)
		50:
			scene.rides.toggle_pause()
		52:
			scene.rides.toggle_pause()
		70:
			scene.rides.leave()
		80:
			scene.spectator.mode = ((number + 1) % 3) as Spectator.Mode
		85:
			headset.right.trigger = 1.0
		86:
			headset.right.trigger = 0.0
		90:
			scene.recentre()


func after_all() -> void:
	TranslationServer.set_locale("en")


# What the process holds, without what the driver compiles.
func _memory_mb() -> float:
	return OS.get_static_memory_usage() / 1048576.0
