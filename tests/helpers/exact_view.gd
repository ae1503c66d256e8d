# SPDX-License-Identifier: MIT
class_name ExactView
extends RefCounted
## An eye near the hole and its camera, in double precision: where on the picture the exact solution
## puts images of stars, and how bright they must be there.
##
## Lengths in Schwarzschild radii, hole at the origin, world axes = ICRS axes. Pixel centres lie at
## +0.5.

## Focal length in pixels of 60 degrees of field over 720 rows: the radiometric scale's reference.
const REFERENCE_FOCAL_PX: float = 623.538290724796
## Summed luminance of a star of magnitude 0 in the reference view at exposure 0.
const STAR_GAIN: float = 30.0
const NOWHERE := Vector2(INF, INF)

var place := Vector3(0, 0, 10)
var observer := SkyObserver.new()
var size := Vector2i(1280, 720)
var vertical_fov_deg: float = 60.0
var right: PackedFloat64Array = [1.0, 0.0, 0.0]
var up: PackedFloat64Array = [0.0, 1.0, 0.0]
var forward: PackedFloat64Array = [0.0, 0.0, -1.0]


## Where the image of a star is and how it is changed. `pixel` is NOWHERE when it is not in front.
class StarSpot:
	extends RefCounted
	var order: int
	var pixel: Vector2
	var magnification: float
	var redshift: float
	## By how much the image is stretched along the ring, sin xi / sin phi.
	var stretch: float


func _init(eye_place: Vector3, eye_motion: LensingTable.Motion) -> void:
	place = eye_place
	observer.motion = eye_motion
	look_along(Vec3D.scaled(outward(), -1.0), Vector3(0.1, 1.0, 0.2))


## Unit vector from the hole to the eye.
func outward() -> PackedFloat64Array:
	return Vec3D.normalized(doubled(place))


## Looks along a direction (of any length), `upward` upwards as far as it lies across.
func look_along(direction: PackedFloat64Array, upward: Vector3) -> void:
	forward = Vec3D.normalized(direction)
	right = Vec3D.normalized(Vec3D.cross(forward, doubled(upward)))
	up = Vec3D.cross(right, forward)


## Looks `angle` radians away from the hole, to the side of `sideways`; that side is `turn` radians
## round the viewing direction in the picture.
func look_beside(angle: float, sideways: Vector3, turn: float = 0.0) -> void:
	var axis := outward()
	var side := across(doubled(sideways), axis)
	var other := Vec3D.cross(axis, side)
	var direction := sum(axis, -cos(angle), side, sin(angle))
	var along := sum(axis, sin(angle), side, cos(angle))
	look_along(direction, Vec3D.to_vector3(sum(along, cos(turn), other, sin(turn))))


## Focal length in pixels.
func focal() -> float:
	return 0.5 * size.y / tan(deg_to_rad(0.5 * vertical_fov_deg))


## Where a direction is seen.
func to_pixel(direction: PackedFloat64Array) -> Vector2:
	var depth := Vec3D.dot(direction, forward)
	if depth < 0.02 * Vec3D.length(direction):
		return NOWHERE
	var scale := focal() / depth
	return Vector2(
		0.5 * size.x + scale * Vec3D.dot(direction, right),
		0.5 * size.y - scale * Vec3D.dot(direction, up)
	)


## The direction, a unit vector, that is seen at a place of the picture.
func to_direction(pixel: Vector2) -> PackedFloat64Array:
	var x := (pixel.x - 0.5 * size.x) / focal()
	var y := (0.5 * size.y - pixel.y) / focal()
	return Vec3D.normalized(sum(sum(right, x, up, y), 1.0, forward, 1.0))


## Half the opening angle of the shadow, radians.
func shadow_half_angle() -> float:
	return observer.shadow(place)["half_angle"]


## The image of order `order` of a star in direction `star`.
func star_spot(star: Vector3, order: int) -> StarSpot:
	var exact: Dictionary = observer.star_image(place, star, order)
	var xi: float = exact["xi"]
	var axis := outward()
	var side := across(doubled(star), axis)
	var spot := StarSpot.new()
	spot.order = order
	spot.magnification = exact["magnification"]
	spot.redshift = exact["redshift"]
	spot.stretch = sin(xi) / Vec3D.sine(doubled(star), axis)
	if is_radial():
		# Finer than the single precision of a Vector3.
		spot.pixel = to_pixel(sum(axis, -cos(xi), side, sin(xi) if order % 2 == 0 else -sin(xi)))
	else:
		spot.pixel = to_pixel(doubled(exact["direction"]))
	return spot


## Is the observer at rest or moving straight to or from the hole?
func is_radial() -> bool:
	return (
		observer.motion != LensingTable.MOTION_ORBIT
		and observer.motion != LensingTable.MOTION_VELOCITY
	)


## Luminance, summed over its pixels, of a star of visual magnitude 0 and temperature `kelvin` seen
## as `spot`.
func luminance_sum(spot: StarSpot, kelvin: float) -> float:
	return (
		flat_luminance_sum(spot.pixel)
		* spot.magnification
		* PlanckLight.shift_factor(kelvin, spot.redshift)
	)


## The same without the hole.
func flat_luminance_sum(pixel: Vector2) -> float:
	var cos_axis := Vec3D.dot(to_direction(pixel), forward)
	return STAR_GAIN * pow(focal() / REFERENCE_FOCAL_PX, 2) / pow(cos_axis, 3)


## Is a place in the picture, `margin` pixels from its border at least?
func holds(pixel: Vector2, margin: float) -> bool:
	return (
		pixel.x > margin
		and pixel.y > margin
		and pixel.x < size.x - margin
		and pixel.y < size.y - margin
	)


## The camera's transform when one Schwarzschild radius is `radius` units and the hole at `hole`.
func camera_transform(radius: float, hole: Vector3 = Vector3.ZERO) -> Transform3D:
	return Transform3D(
		Vec3D.to_vector3(right),
		Vec3D.to_vector3(up),
		Vec3D.to_vector3(Vec3D.scaled(forward, -1.0)),
		place * radius + hole
	)


static func doubled(v: Vector3) -> PackedFloat64Array:
	return [v.x, v.y, v.z]


## p a + q b.
static func sum(
	a: PackedFloat64Array, p: float, b: PackedFloat64Array, q: float
) -> PackedFloat64Array:
	return [a[0] * p + b[0] * q, a[1] * p + b[1] * q, a[2] * p + b[2] * q]


## The unit vector of `v`'s part across the unit vector `axis`.
static func across(v: PackedFloat64Array, axis: PackedFloat64Array) -> PackedFloat64Array:
	return Vec3D.normalized(sum(v, 1.0, axis, -Vec3D.dot(v, axis)))
