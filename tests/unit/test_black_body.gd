# SPDX-License-Identifier: MIT
extends GutTest
## Light of black bodies as core has it, against sums over the CIE table.

const KELVINS: Array[float] = [1000.0, 2500.0, 5772.0, 15000.0, 1e5]


func test_colour(kelvin: float = use_parameters(KELVINS)) -> void:
	var wanted := PlanckLight.colour(kelvin)
	var seen := BlackBody.colour(kelvin)
	assert_almost_eq(seen.dot(PictureMeasure.WEIGHTS), 1.0, 1e-3, "luminance 1")
	if kelvin < 1900.0:
		assert_almost_eq(seen[seen.min_axis_index()], 0.0, 1e-6, "mixed with white just so far")
	else:
		assert_almost_eq(seen, wanted, Vector3.ONE * 2e-3)


func test_luminance(kelvin: float = use_parameters(KELVINS)) -> void:
	var doubled := BlackBody.log2_luminance(2.0 * kelvin) - BlackBody.log2_luminance(kelvin)
	var wanted := log(PlanckLight.shift_factor(kelvin, 2.0)) / log(2.0)
	assert_almost_eq(doubled, wanted, 1e-3 + 1e-4 * wanted)


func test_too_cold() -> void:
	assert_eq(BlackBody.colour(9.0), Vector3.ZERO)
	assert_push_error("10 K")
	assert_true(is_nan(BlackBody.log2_luminance(NAN)))
	assert_push_error("10 K")


func test_the_table() -> void:
	var texels := BlackBody.get_texels()
	assert_eq(texels.size(), 4 * BlackBody.get_texture().get_width())
	assert_eq(BlackBody.get_texture().get_height(), 1)
	assert_same(BlackBody.get_texture(), BlackBody.get_texture(), "all share one")
	for i in range(0, texels.size(), 4):
		var colour := Vector3(texels[i], texels[i + 1], texels[i + 2])
		if absf(colour.dot(PictureMeasure.WEIGHTS) - 1.0) > 1e-3:
			fail_test("texel %d has another luminance than 1" % i)
