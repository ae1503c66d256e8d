# SPDX-License-Identifier: MIT
extends SelfTestCase
## The self-test names the check that belongs to a fault of the tables. Faults are put into what a
## check sends; what it compares with stays.

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func test_the_table_is_computed_where_there_is_none() -> void:
	self_test.stage.tables = null
	await expect([FloatTexturesCheck.new(), StarLookupsCheck.new()], [])


func test_one_damaged_number_of_a_table() -> void:
	var tables := self_test.stage.tables
	var damaged := tables.forward_texels.duplicate()
	damaged[20000] *= 1.000001
	tables.forward = SelfTestTables.texture_of(damaged, tables.forward.get_width())
	await _expect_of_lookups(["float_textures"])


func test_a_wrong_number_in_the_weak_part_of_a_table() -> void:
	var tables := self_test.stage.tables
	var damaged := tables.forward_texels.duplicate()
	for i in range(0, damaged.size(), 4):
		damaged[i] += 0.001
	tables.forward = SelfTestTables.texture_of(damaged, tables.forward.get_width())
	await _expect_of_lookups(["float_textures", "ray_lookups"])


func test_half_floats_instead_of_floats() -> void:
	var tables := self_test.stage.tables
	var width := tables.inverse.get_width()
	var half := Image.FORMAT_RGBAH
	tables.inverse = SelfTestTables.texture_of(tables.inverse_texels, width, half)
	await _expect_of_lookups(["float_textures", "star_lookups"])


func test_a_black_planck_table() -> void:
	var nothing: PackedFloat32Array = []
	nothing.resize(self_test.stage.tables.planck_texels.size())
	self_test.stage.tables.planck = SelfTestTables.texture_of(
		nothing, self_test.stage.tables.planck.get_width()
	)
	await _expect_of_lookups(["float_textures", "planck_lookups"])


func test_an_empty_table_texture() -> void:
	self_test.stage.tables.inverse = SelfTestTables.texture_of([0.0, 0.0, 0.0, 0.0], 1)
	await _expect_of_lookups(["float_textures", "star_lookups"])


func test_a_wrong_motion_in_star_lookups() -> void:
	var check := StarLookupsCheck.new()
	for question in check.questions:
		if question.observer.motion == LensingTable.MOTION_STATIC:
			question.shader_motion = LensQuestion.RAIN
	await expect([check, RayLookupsCheck.new()], ["star_lookups"])


func test_a_slightly_wrong_kappa_in_ray_lookups() -> void:
	var check := RayLookupsCheck.new()
	for question in check.questions:
		question.shader_parameters.w *= 1.001
	await expect([StarLookupsCheck.new(), check], ["ray_lookups"])


func test_instances_in_half_floats() -> void:
	var check := InstanceFloatsCheck.new()
	var half: PackedByteArray = [0, 0]
	for i in check.sent.size():
		half.encode_half(0, check.sent[i])
		check.sent[i] = half.decode_half(0)
	await expect([check, FloatTexturesCheck.new()], ["instance_floats"])


func test_instances_in_disorder() -> void:
	var check := InstanceFloatsCheck.new()
	check.sent.reverse()
	await expect([check], ["instance_floats"])


func _expect_of_lookups(faults: PackedStringArray) -> void:
	var checks: Array[SelfCheck] = [
		FloatTexturesCheck.new(),
		InstanceFloatsCheck.new(),
		StarLookupsCheck.new(),
		RayLookupsCheck.new(),
		PlanckLookupsCheck.new(),
	]
	await expect(checks, faults)
