# SPDX-License-Identifier: MIT
class_name GutInputSender
extends RefCounted
## Sends input events to the Input singleton or to objects, at once or one after the other in time.
##
## Calls can be chained: sender.action_down("fly").hold_for(0.1).wait_frames(1); then await
## sender.idle.

## Emitted when everything queued has been sent.
signal idle


## Something to send after a delay. Counted in physics frames or in seconds.
class Step:
	extends RefCounted

	var frames: int = 0
	var seconds: float = 0.0
	## Null for a plain wait.
	var event: InputEvent = null


var _receivers: Array[Object] = []
var _queue: Array[Step] = []
var _pressed: Array[InputEvent] = []
var _last: InputEvent = null
var _tree: SceneTree = Engine.get_main_loop() as SceneTree


func _init(receiver: Object = null) -> void:
	if receiver != null:
		add_receiver(receiver)


func add_receiver(receiver: Object) -> void:
	_receivers.append(receiver)


func get_receivers() -> Variant:
	return _receivers


func is_idle() -> Variant:
	return _queue.is_empty()


func action_down(which: Variant, strength: Variant = 1.0) -> Variant:
	return send_event(_action(which, strength, true))


func action_up(which: Variant, strength: Variant = 1.0) -> Variant:
	return send_event(_action(which, strength, false))


## A key by its KEY_ constant or its letter.
func key_down(which: Variant) -> Variant:
	return send_event(_key(which, true))


func key_up(which: Variant) -> Variant:
	return send_event(_key(which, false))


## Sends an event at once, or after everything queued before it.
func send_event(event: Variant) -> Variant:
	_last = event
	if _queue.is_empty():
		_send(event)
	else:
		_enqueue(0, 0.0, event)
	return self


## Holds back what follows: seconds, or physics frames as in "3f".
func wait(t: Variant) -> Variant:
	if t is String and str(t).ends_with("f"):
		return wait_frames(str(t).to_int())
	return wait_secs(float(t))


func wait_frames(num_frames: Variant) -> Variant:
	return _enqueue(num_frames, 0.0, null)


func wait_secs(num_secs: Variant) -> Variant:
	return _enqueue(0, num_secs, null)


## Sends the release of the event before it after seconds, or physics frames as in "3f".
func hold_for(duration: Variant) -> Variant:
	if duration is String and str(duration).ends_with("f"):
		return hold_frames(str(duration).to_int())
	return hold_seconds(float(duration))


func hold_frames(duration: int) -> Variant:
	return _enqueue(duration, 0.0, _release_of(_last))


func hold_seconds(duration: float) -> Variant:
	return _enqueue(0, duration, _release_of(_last))


## Releases everything this sender has pressed and not released.
func release_all() -> Variant:
	for event: InputEvent in _pressed.duplicate():
		_send(_release_of(event))
	return self


## Forgets the queue and what is pressed.
func clear() -> void:
	_queue.clear()
	_pressed.clear()
	_last = null
	_listen(false)


func is_key_pressed(which: Variant) -> Variant:
	return _find_pressed(_key(which, true)) != null


func is_action_pressed(which: Variant) -> Variant:
	return _find_pressed(_action(which, 1.0, true)) != null


func _enqueue(frames: int, seconds: float, event: InputEvent) -> GutInputSender:
	var step: Step = Step.new()
	step.frames = frames
	step.seconds = seconds
	step.event = event
	_queue.append(step)
	_listen(true)
	return self


func _listen(on: bool) -> void:
	if on and not _tree.physics_frame.is_connected(_advance):
		_tree.physics_frame.connect(_advance)
	elif not on and _tree.physics_frame.is_connected(_advance):
		_tree.physics_frame.disconnect(_advance)


## One physics frame has passed for the first step of the queue.
func _advance() -> void:
	_queue[0].frames -= 1
	_queue[0].seconds -= _tree.root.get_physics_process_delta_time()
	while not _queue.is_empty() and _queue[0].frames <= 0 and _queue[0].seconds <= 0.0:
		var step: Step = _queue.pop_front()
		if step.event != null:
			_send(step.event)
	if _queue.is_empty():
		_listen(false)
		idle.emit()


func _send(event: InputEvent) -> void:
	var earlier: InputEvent = _find_pressed(event)
	if earlier != null:
		_pressed.erase(earlier)
	if event.is_pressed() and _release_of(event) != null:
		_pressed.append(event)
	for receiver: Object in _receivers:
		if receiver == Input:
			Input.parse_input_event(event)
			continue
		for method: String in ["_input", "_gui_input", "_unhandled_input"]:
			if receiver.has_method(method):
				receiver.call(method, event)


func _find_pressed(event: InputEvent) -> InputEvent:
	for pressed: InputEvent in _pressed:
		if pressed.is_match(event) and pressed.get_class() == event.get_class():
			return pressed
	return null


## The same event with pressed = false; null for an event that cannot be released, such as a motion.
func _release_of(event: InputEvent) -> InputEvent:
	if event == null or "pressed" not in event:
		return null
	var release: InputEvent = event.duplicate()
	release.set("pressed", false)
	return release


func _action(which: StringName, strength: float, pressed: bool) -> InputEventAction:
	var event: InputEventAction = InputEventAction.new()
	event.action = which
	event.strength = strength
	event.pressed = pressed
	return event


func _key(which: Variant, pressed: bool) -> InputEventKey:
	var event: InputEventKey = InputEventKey.new()
	event.keycode = OS.find_keycode_from_string(which) if which is String else which
	event.pressed = pressed
	return event
