# SPDX-License-Identifier: MIT
class_name LensQuestion
extends RefCounted
## An observer, a place and a direction, about which both the exact solution and the shaders'
## functions are asked.

enum { STATIC, RAIN, INFALL, ORBIT, VELOCITY, KINDS }

const TEXELS: int = 3

var observer := SkyObserver.new()
## From the hole in Schwarzschild radii.
var place: Vector3
## To a star, or in which the eye looks.
var direction: Vector3
var order: int = 0
## What the shader is told of the motion (see observer.gdshaderinc).
var shader_motion: int
var shader_parameters := Vector4.ZERO


## An observer of this kind at a random place.
static func anywhere(rng: RandomNumberGenerator, kind: int) -> LensQuestion:
	var question := LensQuestion.new()
	# Static observers are outside of the horizon, stable orbits from r = 3 on.
	var nearest: float = [1.05, 0.05, 0.05, 3.0, 0.05][kind]
	var r := exp(rng.randf_range(log(nearest), log(1e4)))
	question.place = somewhere(rng) * r
	question.shader_motion = kind
	match kind:
		STATIC:
			question.observer.motion = LensingTable.MOTION_STATIC
		RAIN:
			question.observer.motion = LensingTable.MOTION_RAIN
		INFALL:
			question.observer.motion = LensingTable.MOTION_INFALL
			question.observer.energy = 1.5
			question.shader_parameters.w = question.observer.energy
		ORBIT:
			question.observer.motion = LensingTable.MOTION_ORBIT
			question.observer.axis = Vector3(0.36, 0.8, -0.48)
			question._tell(question.observer.axis)
		VELOCITY:
			question.observer.motion = LensingTable.MOTION_VELOCITY
			question.observer.celerity = Vector3(0.3, -0.5, 0.4)
			question._tell(question.observer.celerity)
	return question


## A random unit vector.
static func somewhere(rng: RandomNumberGenerator) -> Vector3:
	return Vector3(rng.randfn(), rng.randfn(), rng.randfn()).normalized()


## The questions as the shaders read them, one a row.
static func texture_of(questions: Array[LensQuestion]) -> ImageTexture:
	var texels: PackedFloat32Array = []
	for q in questions:
		texels.append_array([q.place.x, q.place.y, q.place.z, q.shader_motion])
		texels.append_array([q.direction.x, q.direction.y, q.direction.z, q.order])
		var given := q.shader_parameters
		texels.append_array([given.x, given.y, given.z, given.w])
	return SelfTestTables.texture_of(texels, TEXELS)


func _tell(given: Vector3) -> void:
	shader_parameters = Vector4(given.x, given.y, given.z, 0.0)
