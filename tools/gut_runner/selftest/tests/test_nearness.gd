# SPDX-License-Identifier: MIT
extends GutTest
## Nearly equal numbers and vectors.


func test_pass_almost_eq() -> void:
	assert_almost_eq(0, 1, 1)
	assert_almost_eq(1.2, 1.0, 0.5)
	assert_almost_eq(0.5, 1.0, 0.5, "the ends belong to it")
	assert_almost_eq(1.5, 1.0, 0.5)
	assert_almost_eq(Vector2(0.75, 1.25), Vector2(1, 1), Vector2(0.25, 0.25))
	assert_almost_eq(Vector3(1, 2, 3), Vector3(1, 2, 3), Vector3(0.1, 0.1, 0.1))
	assert_almost_eq(Vector4(1, 2, 3, 4), Vector4(1, 2, 3, 4), Vector4(0.1, 0.1, 0.1, 0.1))


func test_fail_almost_eq_outside() -> void:
	assert_almost_eq(2.6, 3.0, 0.2)


func test_fail_almost_eq_one_component_outside() -> void:
	assert_almost_eq(Vector2(0.5, 1.5), Vector2(1, 1), Vector2(0.75, 0.25))


func test_fail_almost_eq_last_component_outside() -> void:
	assert_almost_eq(Vector3(1, 1, 9), Vector3(1, 1, 1), Vector3(0.1, 0.1, 0.1))


func test_fail_almost_eq_nan() -> void:
	assert_almost_eq(NAN, 1.0, 10.0)


func test_fail_almost_eq_vector_with_nan() -> void:
	assert_almost_eq(Vector3(1, NAN, 1), Vector3(1, 1, 1), Vector3(1, 1, 1))


func test_pass_almost_ne() -> void:
	assert_almost_ne(2.6, 3.0, 0.2)
	assert_almost_ne(Vector2(5, 1), Vector2(1, 1), Vector2(1, 1))


func test_fail_almost_ne() -> void:
	assert_almost_ne(2.9, 3.0, 0.2)


func test_pass_almost_eq_of_mixed_numbers() -> void:
	assert_almost_eq(1, 1.2, 0.5)


func test_pass_almost_eq_infinite() -> void:
	assert_almost_eq(INF, INF, 1.0)


func test_fail_almost_eq_interval_of_other_type() -> void:
	assert_almost_eq(Vector2(1, 1), Vector2(1, 1), 0.5)


func test_fail_almost_eq_colour() -> void:
	assert_almost_eq(Color(1, 1, 1), Color(1, 1, 1), Color(0.1, 0.1, 0.1, 0.1))


func test_fail_almost_eq_quaternion() -> void:
	assert_almost_eq(Quaternion(), Quaternion(), Quaternion())


func test_pass_almost_eq_whole_vectors() -> void:
	assert_almost_eq(Vector3i(1, 1, 1), Vector3i(1, 2, 1), Vector3i(1, 1, 1))
