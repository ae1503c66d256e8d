# SPDX-License-Identifier: MIT
class_name SimulatedHeadset
extends RefCounted
## Moves the head and the hands of a headset that does not exist: Monado's "remote" driver takes its
## poses and buttons over a local connection.

const BYTES: int = 376
const MAGIC: String = "mndrmt3"
const HEAD_AT: int = 104
const HANDS_AT: int = 136
## 1: what is told of the eyes counts.
const EYES_COUNT_AT: int = 132
const EYES_AT: int = 8
const EYE_BYTES: int = 48
## Half the distance of the eyes, metres.
const HALF_EYES: float = 0.0315
## The edges of each eye's field: left, right, up, down, radians; square pixels at 4 to 3.
const LEFT_FIELD: PackedFloat32Array = [-0.9, 0.8, 0.7095, -0.7095]
const RIGHT_FIELD: PackedFloat32Array = [-0.8, 0.9, 0.7095, -0.7095]
## The variable that names the port.
const PORT_VARIABLE: String = "BLACKHOLE_HEADSET_PORT"

## In the room, metres.
var head := Transform3D(Basis.IDENTITY, Vector3(0.0, 1.6, 0.0))
var left := SimulatedHand.new(Vector3(-0.2, 1.3, -0.4))
var right := SimulatedHand.new(Vector3(0.2, 1.3, -0.4))

var _connection := StreamPeerTCP.new()


## True when there is one to move.
static func is_there() -> bool:
	return OS.get_environment(PORT_VARIABLE).is_valid_int()


## Connects; false when nobody listens within `seconds`.
func open(seconds: float = 5.0) -> bool:
	_connection = StreamPeerTCP.new()
	var until := Time.get_ticks_msec() + roundi(seconds * 1000.0)
	while Time.get_ticks_msec() < until:
		if _connection.get_status() == StreamPeerTCP.STATUS_NONE:
			_connection.connect_to_host("127.0.0.1", OS.get_environment(PORT_VARIABLE).to_int())
		_connection.poll()
		if _connection.get_status() == StreamPeerTCP.STATUS_CONNECTED:
			_connection.set_no_delay(true)
			return true
		if _connection.get_status() == StreamPeerTCP.STATUS_ERROR:
			_connection.disconnect_from_host()
			_connection = StreamPeerTCP.new()
		OS.delay_msec(20)
	return false


## Makes everything as set; true when it was sent.
func send() -> bool:
	_connection.poll()
	var waiting := _connection.get_available_bytes()
	if waiting > 0:
		_connection.get_data(waiting)  # it tells its own state, which we know
	return _connection.put_data(to_bytes()) == OK


func close() -> void:
	_connection.disconnect_from_host()


func to_bytes() -> PackedByteArray:
	var bytes: PackedByteArray = []
	bytes.resize(BYTES)
	var magic := MAGIC.to_ascii_buffer()
	for i in magic.size():
		bytes[i] = magic[i]
	for eye in 2:
		var at := EYES_AT + eye * EYE_BYTES
		var field := LEFT_FIELD if eye == 0 else RIGHT_FIELD
		for edge in 4:
			bytes.encode_float(at + 4 * edge, field[edge])
		var side := -HALF_EYES if eye == 0 else HALF_EYES
		write_pose(bytes, at + 16, Transform3D(Basis.IDENTITY, Vector3(side, 0.0, 0.0)))
	write_pose(bytes, HEAD_AT, head)
	bytes[EYES_COUNT_AT] = 1
	left.write(bytes, HANDS_AT)
	right.write(bytes, HANDS_AT + SimulatedHand.BYTES)
	return bytes


## Quaternion x y z w, then the place.
static func write_pose(into: PackedByteArray, at: int, pose: Transform3D) -> void:
	var turn := pose.basis.get_rotation_quaternion()
	var numbers: Array[float] = [
		turn.x, turn.y, turn.z, turn.w, pose.origin.x, pose.origin.y, pose.origin.z
	]
	for i in numbers.size():
		into.encode_float(at + 4 * i, numbers[i])
