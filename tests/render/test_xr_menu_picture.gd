# SPDX-License-Identifier: MIT
extends MenuCase
## The menu as an eye sees it: words as large as they should be, and in contrast to their ground
## whatever sky is behind.
##
## With BLACKHOLE_PICTURES set, pictures of all pages are written to that folder.

const FIELD: float = 80.0
const LEAST_CONTRAST: float = 4.5

var _viewport: SubViewport
var _camera: Camera3D
var _world: Environment
var _booth: MenuBooth

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_each() -> void:
	super()
	_viewport = SubViewport.new()
	_viewport.own_world_3d = true
	_viewport.size = Vector2i(640, 480)
	_viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var world := SkyBooth.dark_world()
	_world = world.environment
	_booth = MenuBooth.new()
	_booth.sky.visible = false
	_camera = Camera3D.new()
	_camera.keep_aspect = Camera3D.KEEP_WIDTH
	_camera.fov = FIELD
	for node: Node in [world, _booth, _camera]:
		_viewport.add_child(node)
	add_child_autofree(_viewport)
	_camera.global_transform = _booth.head.global_transform
	_camera.make_current()


func _photo() -> Image:
	await _booth.settle()
	for frame in 2:
		await RenderingServer.frame_post_draw
	return _viewport.get_texture().get_image()


# Where a row or a label is in the picture.
func _frame_of(control: Control) -> Rect2i:
	var surface := _booth.menu.surface
	var rect := control.get_global_rect()
	var frame := Rect2()
	for corner: Vector2 in [rect.position, rect.end]:
		var share := corner / Vector2(surface.pixels) - Vector2.ONE * 0.5
		var flat := share * surface.picture.get_extent() * Vector2(1.0, -1.0)
		var at := _camera.unproject_position(surface.to_global(Vector3(flat.x, flat.y, 0.0)))
		frame = Rect2(at, Vector2.ZERO) if corner == rect.position else frame.expand(at)
	return Rect2i(frame.grow(-2.0))


# As WCAG has it.
func _contrast(one: float, other: float) -> float:
	return (maxf(one, other) + 0.05) / (minf(one, other) + 0.05)


func _luminances(picture: Image, frame: Rect2i) -> Array[float]:
	var values: Array[float] = []
	for y in range(frame.position.y, frame.end.y):
		for x in range(frame.position.x, frame.end.x):
			values.append(picture.get_pixel(x, y).srgb_to_linear().get_luminance())
	values.sort()
	return values


func test_words_stand_out_before_any_sky() -> void:
	_booth.refused[VisitPages.FALL] = "No."
	# Twice white is the brightest that the Mobile renderer's buffer holds.
	for background: Color in [Color.BLACK, Color.WHITE, Color(2.0, 2.0, 2.0)]:
		_world.background_color = background
		await _booth.show_page(VisitPages.RIDES)
		_booth.gaze_at(_booth.place_of(_booth.rows()[2]), 0.1)
		_booth.pointer.hide()
		var picture := await _photo()
		for row in _booth.rows():
			var values := _luminances(picture, _frame_of(row))
			var ground := values[values.size() >> 1]
			# The brightest or darkest hundredth is what the words are drawn with.
			var ink := values[-1 - floori(values.size() / 100.0)]
			if row.lit and not row.disabled:
				ink = values[floori(values.size() / 100.0)]
			assert_gt(_contrast(ink, ground), LEAST_CONTRAST, "%s on %s" % [row.words, background])
		for node: String in ["%Title", "%Foot"]:
			var label: Label = _booth.menu.sheet.get_node(node)
			var values := _luminances(picture, _frame_of(label))
			var contrast := _contrast(
				values[-1 - floori(values.size() / 200.0)], values[values.size() >> 1]
			)
			assert_gt(contrast, LEAST_CONTRAST, "%s on %s" % [label.text, background])


func test_the_row_under_the_ray_is_plain_to_see() -> void:
	await _booth.show_page(VisitPages.RIDES)
	_booth.pointer.hide()
	_booth.gaze_at(_booth.place_of(_booth.rows()[2]), 0.1)
	var picture := await _photo()
	var lit := _luminances(picture, _frame_of(_booth.rows()[2]))
	var other := _luminances(picture, _frame_of(_booth.rows()[3]))
	assert_gt(_contrast(lit[lit.size() >> 1], other[other.size() >> 1]), 3.0)


func test_capitals_are_as_tall_as_their_em_says() -> void:
	await _booth.show_page(VisitPages.RIDES)
	var picture := await _photo()
	# "Fall in" begins with a capital F, whose stem stands in the row's first columns.
	var row := _booth.rows()[1]
	var frame := _frame_of(row)
	var stem := 0
	for x in range(frame.position.x, frame.position.x + frame.size.y):
		var tall := 0.0
		for y in range(frame.position.y, frame.end.y):
			tall += clampf((picture.get_pixel(x, y).get_luminance() - 0.2) / 0.5, 0.0, 1.0)
		stem = maxi(stem, roundi(tall))
	# Capitals are 0.714 em tall in the engine's own font.
	var em_pixels := stem / 0.714
	var per_radian := 0.5 * _viewport.size.x / tan(deg_to_rad(0.5 * FIELD))
	var degrees := rad_to_deg(em_pixels / per_radian)
	gut.p("an em is %.2f degrees" % degrees)
	assert_between(degrees, 2.5, 3.1)


func test_small_words_do_not_shimmer() -> void:
	_viewport.size = Vector2i(320, 240)
	await _booth.show_page(VisitPages.SKY)
	# Seen from places a fraction of a pixel apart, a row sends as much light.
	var sums: Array[float] = []
	for step in 8:
		_camera.rotate_object_local(Vector3.UP, deg_to_rad(0.25) / 8.0)
		var picture := await _photo()
		var sum := 0.0
		for value in _luminances(picture, Rect2i(60, 60, 200, 120)):
			sum += value
		sums.append(sum)
	var least: float = sums.min()
	var most: float = sums.max()
	gut.p("light changes by %.2f %%" % (100.0 * (most / least - 1.0)))
	assert_lt(most / least - 1.0, 0.02)


func test_the_veils_cover_the_menu_and_the_cursor_lies_over_it() -> void:
	await _booth.show_page(VisitPages.RIDES)
	var row := _booth.rows()[3]
	_booth.gaze_at(_booth.place_of(row), 0.4)
	_booth.pointer.set_process(false)
	var picture := await _photo()
	var at := Vector2i(_camera.unproject_position(_booth.place_of(row)))
	var dot := picture.get_pixelv(at)
	assert_gt(minf(dot.r, minf(dot.g, dot.b)), 0.9, "a white dot")
	var curtain := Curtain.new()
	_camera.add_child(curtain)
	curtain.set_darkness(self, 1.0)
	picture = await _photo()
	assert_lt(picture.get_pixelv(at).get_luminance(), 0.01)


func test_pictures_of_all_pages() -> void:
	var folder := OS.get_environment("BLACKHOLE_PICTURES")
	if folder.is_empty():
		pass_test("nobody asked for pictures")
		return
	var pose := _booth.head.global_transform
	_camera.rotate_object_local(Vector3.RIGHT, deg_to_rad(-_booth.menu.lower_degrees))
	_world.background_color = Color(0.3, 0.25, 0.2)
	_booth.told[VisitPages.SPECTATOR] = "View"
	_booth.told[VisitPages.OBSERVER] = "falling"
	for locale in LanguagePage.locales():
		TranslationServer.set_locale(locale)
		_booth.refused[VisitPages.LEAVE_RIDE] = tr(
			"There is no circular orbit here: it takes more than 1.5 rₛ."
		)
		for page: StringName in _booth.pages.make():
			_booth.head.global_transform = pose
			await _booth.show_page(page)
			var row := _booth.rows()[-1 if page == VisitPages.RIDES else 2]
			_booth.gaze_at(_booth.place_of(row), 1.1)
			for size: Vector2i in [Vector2i(640, 480), Vector2i(320, 240)]:
				_viewport.size = size
				var picture := await _photo()
				picture.save_png("%s/%s_%s_%d.png" % [folder, locale, page, size.x])
				assert_eq(picture.get_size(), size)
	await _photograph_disc(folder, pose)


# The disc and a hand's beam, by who looks down a little.
func _photograph_disc(folder: String, pose: Transform3D) -> void:
	_booth.menu.close()
	_booth.head.global_transform = pose.rotated_local(Vector3.RIGHT, deg_to_rad(-24.0))
	_camera.global_transform = _booth.head.global_transform
	var disc := MenuDisc.new()
	disc.head = _booth.head
	_booth.add_child(disc)
	_booth.hand.here = true
	_booth.hand.aim_at(pose * Vector3(0.3, -0.3, -1.5))
	_booth.pointer.advance(0.3)
	for size: Vector2i in [Vector2i(640, 480), Vector2i(320, 240)]:
		_viewport.size = size
		(await _photo()).save_png("%s/disc_%d.png" % [folder, size.x])
	_booth.hand.aim_at(disc.global_position)
	_booth.pointer.advance(0.3)
	(await _photo()).save_png("%s/disc_lit_320.png" % folder)
