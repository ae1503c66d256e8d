# SPDX-License-Identifier: MIT
extends GutTest
## The visitor's room round the hole: what is told without a headset that offers it, and what
## changes in the picture.

var _passthrough: Passthrough
var _session: XrSession
var _viewport: SubViewport
var _sky: BlackHoleSky
var _environment: Environment


func before_each() -> void:
	_viewport = SubViewport.new()
	_viewport.own_world_3d = true
	_session = XrSession.new()
	_session.viewport = _viewport
	_sky = BlackHoleSky.new()
	_environment = Environment.new()
	_environment.background_mode = Environment.BG_CLEAR_COLOR
	_environment.background_color = Color.RED
	_passthrough = Passthrough.new()
	_passthrough.session = _session
	_passthrough.viewport = _viewport
	_passthrough.sky = _sky
	_viewport.add_child(_sky)
	for node: Node in [_viewport, _session, _passthrough]:
		add_child_autofree(node)
	_viewport.find_world_3d().environment = _environment
	watch_signals(_passthrough)


func test_without_a_headset_it_is_not_offered_and_says_why() -> void:
	assert_false(_passthrough.is_offered())
	assert_string_contains(_passthrough.why_not(), "No headset")
	assert_false(_passthrough.set_on(true))
	assert_false(_passthrough.is_on())
	assert_false(_viewport.transparent_bg)
	assert_true(_passthrough.set_on(false), "it is off")
	assert_signal_not_emitted(_passthrough, "changed")


func test_it_takes_a_headset_that_blends() -> void:
	var opaque := XRInterface.XR_ENV_BLEND_MODE_OPAQUE
	var additive := XRInterface.XR_ENV_BLEND_MODE_ADDITIVE
	var alpha := XRInterface.XR_ENV_BLEND_MODE_ALPHA_BLEND
	assert_string_contains(_passthrough.reason_of([opaque]), "does not show the room")
	assert_string_contains(_passthrough.reason_of([opaque, additive]), "does not show the room")
	assert_eq(_passthrough.reason_of([opaque, alpha]), "")


func test_the_picture_becomes_clear_and_is_afterwards_as_it_was() -> void:
	_passthrough.clearness = 0.75
	_passthrough.call("_show_room", true)
	assert_true(_passthrough.is_on())
	assert_true(_viewport.transparent_bg)
	assert_almost_eq(_sky.see_through, 0.75, 1e-9)
	assert_eq(_environment.background_mode, Environment.BG_COLOR)
	assert_eq(_environment.background_color.a, 0.0)
	assert_signal_emitted_with_parameters(_passthrough, "changed", [true])
	_session.lost.emit()
	assert_false(_passthrough.is_on(), "a headset that is gone shows no room")
	assert_false(_viewport.transparent_bg)
	assert_eq(_sky.see_through, 0.0)
	assert_eq(_environment.background_mode, Environment.BG_CLEAR_COLOR)
	assert_eq(_environment.background_color, Color.RED)
	assert_signal_emit_count(_passthrough, "changed", 2)
