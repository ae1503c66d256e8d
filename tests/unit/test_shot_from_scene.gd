# SPDX-License-Identifier: MIT
extends GutTest
## A scene described as a shot: the shot's reader finds in it what the scene shows, to the digit.

const SIZE := Vector2i(640, 360)

var _sky: BlackHoleSky
var _camera: Camera3D
var _disk: AccretionDisk


func before_each() -> void:
	_sky = BlackHoleSky.new()
	_camera = Camera3D.new()
	_disk = AccretionDisk.new()
	_disk.hide()
	_sky.add_child(_disk)
	add_child_autofree(_sky)
	add_child_autofree(_camera)
	_camera.position = Vector3(3.1, -2.7, 8.3)
	_camera.look_at(Vector3(1.0, 0.5, -2.0), Vector3(0.3, 1.0, 0.2))


func _described(labels: SkyLabels = null) -> ShotFromScene:
	return ShotFromScene.describe(_sky, _camera, SIZE, _disk, labels)


# As a file and back.
func _spec(labels: SkyLabels = null) -> ShotSpec:
	var described := _described(labels)
	assert_eq(described.refusal, "")
	var spec := ShotSpec.from_data(JSON.parse_string(described.to_json()))
	assert_eq(spec.error, "")
	return spec


func test_place_and_view_are_exact() -> void:
	_camera.fov = 41.5
	_sky.schwarzschild_radius = 0.5
	_sky.rotation = Vector3(0.4, -1.0, 2.0)
	var spec := _spec()
	assert_eq(spec.resolution, SIZE)
	assert_eq(spec.vertical_fov_deg, 41.5)
	var axes := _sky.global_basis.orthonormalized().inverse() * _camera.global_basis
	var place := _sky.global_basis.inverse() * _camera.position / 0.5
	assert_almost_eq(Vec3D.to_vector3(spec.position), place, Vector3.ONE * 1e-5)
	# A hundredth of a pixel is 0.00002 here.
	assert_almost_eq(Vec3D.to_vector3(spec.forward), -axes.z, Vector3.ONE * 1e-6)
	assert_almost_eq(Vec3D.to_vector3(spec.up), axes.y, Vector3.ONE * 1e-6)


func test_motions(motion: LensingTable.Motion = use_parameters([0, 1, 2, 3, 4])) -> void:
	var observer := SkyObserver.new()
	observer.motion = motion
	observer.energy = SkyObserver.energy_from_rest(30.0)
	observer.outgoing = true
	observer.axis = Vector3(0.1, 0.9, -0.3)
	observer.celerity = Vector3(0.7, -0.2, 0.4)
	_sky.observer = observer
	var place := _camera.position
	var shown := _spec().observer.to_sky_observer()
	assert_eq(shown.motion, motion)
	assert_almost_eq(shown.celerity_at(place), observer.celerity_at(place), Vector3.ONE * 1e-6)
	observer.relative_to_static = true
	shown = _spec().observer.to_sky_observer()
	assert_almost_eq(shown.celerity_at(place), observer.celerity_at(place), Vector3.ONE * 1e-6)


func test_who_cannot_be_is_described_as_who_is_drawn() -> void:
	_sky.observer_motion = LensingTable.MOTION_ORBIT
	_camera.position = Vector3(0.0, 0.0, 1.4)
	assert_eq(_spec().observer.motion, LensingTable.MOTION_RAIN)
	_sky.observer = null
	assert_eq(_spec().observer.motion, LensingTable.MOTION_STATIC)
	_camera.position = Vector3(0.0, 0.0, 0.4)
	assert_eq(_spec().observer.motion, LensingTable.MOTION_RAIN)


func test_light_and_effects() -> void:
	_sky.exposure = 1.75
	_sky.image_orders = 4
	_sky.magnitude_limit = 6.5
	_sky.psf_model = BlackHoleSky.PSF_AIRY
	_sky.aperture_mm = 0.2
	_sky.effect_doppler = false
	_sky.saturation = 1.5
	_sky.background = BlackHoleSky.BACKGROUND_GRID
	_sky.projection = BlackHoleSky.PROJECTION_MOLLWEIDE
	_sky.catalogue = StarCatalogue.new()
	_sky.overlays = BlackHoleSky.OVERLAY_SHADOW_EDGE | BlackHoleSky.OVERLAY_MOTION
	var spec := _spec()
	assert_eq(spec.exposure_ev, 1.75)
	assert_null(spec.auto_exposure)
	assert_eq(spec.orders, 4)
	assert_eq(spec.magnitude_limit, 6.5)
	assert_eq(spec.point_spread.model, BlackHoleSky.PSF_AIRY)
	assert_eq(spec.point_spread.aperture_mm, _sky.aperture_mm)
	assert_eq(spec.point_spread.sigma_px, PictureScale.star_sigma(SIZE.y))
	assert_eq(spec.effects.off, PackedStringArray(["doppler"]))
	assert_eq(spec.effects.saturation, 1.5)
	assert_eq(spec.background, ShotSpec.Background.GRID)
	assert_eq(spec.projection, BlackHoleSky.PROJECTION_MOLLWEIDE)
	assert_eq(spec.overlays, _sky.overlays)
	assert_true(spec.has_stars)
	_sky.stars_visible = false
	assert_false(_spec().has_stars)


func test_names_in_their_language() -> void:
	var labels: SkyLabels = autofree(SkyLabels.new())
	labels.constellations_shown = true
	var locale := TranslationServer.get_locale()
	TranslationServer.set_locale("de_AT")
	var spec := _spec(labels)
	TranslationServer.set_locale("fr")
	var other := _spec(labels)
	TranslationServer.set_locale(locale)
	assert_true(spec.star_names)
	assert_true(spec.constellation_names)
	assert_eq(spec.language, "de")
	assert_eq(other.language, "la")


func test_the_disk_to_its_last_property() -> void:
	DiskPresets.apply(_disk, "film")
	_disk.show()
	_disk.basis = Basis.from_euler(Vector3(0.5, 1.2, -0.3))
	_disk.time = 123.456
	_disk.retrograde = true
	_disk.ring_radii = [3.0, 5.5]
	_sky.mass_solar = 4.3e6
	var spec := _spec()
	var again: AccretionDisk = autofree(AccretionDisk.new())
	spec.disk.apply_to(again)
	assert_eq(spec.disk.mass_solar, _sky.mass_solar)
	assert_almost_eq(again.basis.x, _disk.basis.x, Vector3.ONE * 1e-6)
	assert_almost_eq(again.basis.y, _disk.basis.y, Vector3.ONE * 1e-6)
	assert_eq(again.look, _disk.look)
	for property: String in ShotDisk.PROPERTIES.values():
		assert_eq(again.get(property), _disk.get(property), property)


func test_no_hole_and_half_a_hole() -> void:
	_sky.lensing = 0.0
	_sky.observer_motion = LensingTable.MOTION_RAIN
	_sky.overlays = BlackHoleSky.OVERLAY_SHADOW_EDGE | BlackHoleSky.OVERLAY_MOTION
	var spec := _spec()
	assert_false(spec.hole)
	assert_eq(spec.observer.motion, LensingTable.MOTION_STATIC)
	assert_eq(spec.overlays, BlackHoleSky.OVERLAY_MOTION)
	_sky.lensing = 0.4
	var described := _described()
	assert_string_contains(described.refusal, "coming or going")
	assert_eq(described.shot, {})
