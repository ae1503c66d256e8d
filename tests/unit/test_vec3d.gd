# SPDX-License-Identifier: MIT
extends GutTest
## Vectors in double precision.

const A: Array = [1.0, 2.0, 2.0]
const B: Array = [-2.0, 0.5, 4.0]


func test_products() -> void:
	assert_eq(Vec3D.length(A), 3.0)
	assert_eq(Vec3D.dot(A, B), 7.0)
	assert_eq(Vec3D.cross(A, B), PackedFloat64Array([7.0, -8.0, 4.5]))
	assert_eq(Vec3D.cross([1, 0, 0], [0, 1, 0]), PackedFloat64Array([0.0, 0.0, 1.0]))


func test_sums() -> void:
	assert_eq(Vec3D.subtract(A, B), PackedFloat64Array([3.0, 1.5, -2.0]))
	assert_eq(Vec3D.scaled(A, -2.0), PackedFloat64Array([-2.0, -4.0, -4.0]))


func test_unit_vectors_and_angles() -> void:
	assert_almost_eq(Vec3D.length(Vec3D.normalized(B)), 1.0, 1e-15)
	assert_almost_eq(Vec3D.sine([1, 0, 0], [1, 1, 0]), sqrt(0.5), 1e-15)
	assert_eq(Vec3D.sine(A, Vec3D.scaled(A, -3.0)), 0.0)


func test_digits_beyond_single_precision_are_kept() -> void:
	var far: PackedFloat64Array = [2e4, 0.0, 0.0]
	var near: PackedFloat64Array = [2e4 - 1e-6, 1e-6, 0.0]
	var between := Vec3D.normalized(Vec3D.subtract(near, far))
	assert_almost_eq(between[0], -sqrt(0.5), 1e-5)
	assert_almost_eq(between[1], sqrt(0.5), 1e-5)


func test_the_engine_s_vector() -> void:
	assert_eq(Vec3D.to_vector3(A), Vector3(1, 2, 2))
