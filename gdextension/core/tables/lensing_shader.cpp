// SPDX-License-Identifier: MIT
#include "core/tables/lensing_shader.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cstddef>

namespace lensing_shader {

// The shading language's names, for the included source.
using namespace glm;       // NOLINT(google-build-using-namespace)
using sampler2D = Texture; // NOLINT(readability-identifier-naming)

namespace {

vec4 texelFetch(const Texture &table, ivec2 at, int /*level*/) { // NOLINT(readability-identifier-naming)
	const float *texel =
			table.texels->data() + 4 * (static_cast<std::ptrdiff_t>(at.y) * table.columns + at.x);
	return {texel[0], texel[1], texel[2], texel[3]};
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
// The .gdshaderinc files of these names, see sources.cmake.
#include "observer_source.inc"

#include "lensing_source.inc"

#include "effects_source.inc"

#include "ray_tables_source.inc"

#include "disk_crossing_source.inc"

#include "disk_delay_source.inc"

#include "disk_gas_source.inc"
#pragma GCC diagnostic pop

LensEye eye_at(float u) {
	return lens_eye(vec3(0.0F, 0.0F, 1.0F / u), LENS_MOTION_RAIN, vec4(0.0F));
}

} // namespace

Motion motion_of(const blackhole::ObserverField &observer) {
	using blackhole::ObserverMotion;
	Motion result;
	const auto energy = static_cast<float>(observer.energy);
	switch (observer.motion) {
		case ObserverMotion::kStatic:
			result.code = LENS_MOTION_STATIC;
			break;
		case ObserverMotion::kRain:
			result.code = LENS_MOTION_RAIN;
			break;
		case ObserverMotion::kInfall:
			result.code = LENS_MOTION_INFALL;
			result.parameters.w = observer.outgoing ? -energy : energy;
			break;
		case ObserverMotion::kOrbit:
			result.code = LENS_MOTION_ORBIT;
			result.parameters = vec4(vec3(normalize(observer.axis)), energy);
			break;
		case ObserverMotion::kVelocity:
			result.code =
					observer.relative_to_static ? LENS_MOTION_VELOCITY_FROM_STATIC : LENS_MOTION_VELOCITY;
			result.parameters = vec4(vec3(observer.celerity), energy);
			break;
	}
	return result;
}

float shadow_sigma(float u) {
	return eye_at(u).sigma_c;
}

Ray ray_of_angle(const Texture &inverse, float u, Angle angle) {
	Ray ray{};
	rays_of_angles(inverse, u, &angle, 1, &ray);
	return ray;
}

void rays_of_angles(const Texture &inverse, float u, const Angle *angles, std::size_t count, Ray *rays) {
	const LensEye eye = eye_at(u);
	const LensRow row = lens_row(eye);
	const float x_scale = inversesqrt(0.5F * eye.w_table);
	for (std::size_t i = 0; i < count; ++i) {
		const float t = angles[i].t;
		// The lines of lens_star_image() between its t and its sigma.
		const float q = sqrt(t * t + 2.0F * eye.w);
		const float q_table = sqrt(t * t + 2.0F * eye.w_table);
		const float s0 = t > 0.0F ? 0.5F * (t + q) : eye.w / (q - t);
		const float s_table = t > 0.0F ? 0.5F * (t + q_table) : eye.w_table / (q_table - t);
		const float big_x = clamp(log(s_table * x_scale), -LENS_X_LIMIT, LENS_X_LIMIT);
		const vec2 column = lens_column(big_x);
		const LensSample ratio = lens_sample(inverse, row, column.x);
		const float clearance = s0 * ratio.value;
		const float slope = angles[i].t_slope * s0 * (ratio.value / q + ratio.slope * column.y / q_table);
		rays[i] = {clearance, eye.sigma_c + clearance, slope};
	}
}

vec2 angle_of_ray(const Texture &forward, float u, float y) {
	const LensEye eye = eye_at(u);
	return lens_orbital_angle(forward, eye, lens_row(eye), y);
}

Image star_image(const Texture &inverse, vec3 place, vec3 star, int order, const Motion &motion,
		float angular_radius, int effects) {
	const LensEye eye = lens_eye(place, motion.code, motion.parameters);
	const LensPath path = lens_path(eye, star, order);
	const LensImage image = lens_star_image(inverse, eye, lens_row(eye), path);
	const EffectImage seen = effect_image(eye, effects, path, image, star, angular_radius);
	return {seen.direction, seen.magnification, seen.redshift};
}

RoughPlace rough_place(vec3 place, vec3 star, int order, const Motion &motion) {
	const LensEye eye = lens_eye(place, motion.code, motion.parameters);
	const LensPath path = lens_path(eye, star, order);
	const float sigma = lens_rough_sigma(eye, path);
	return {lens_direction(eye, path, sigma), lens_rough_error(eye),
			lens_magnification_limit(eye, path, 0.0F), lens_redshift_limit(eye, sigma)};
}

Sky trace(const Texture &forward, vec3 place, vec3 view_direction, const Motion &motion, int effects) {
	const LensEye eye = lens_eye(place, motion.code, motion.parameters);
	const LensRay ray =
			effect_trace(forward, eye, lens_row(eye), effects, effect_framed(eye, effects, view_direction));
	return {ray.clearance <= 0.0F, ray.sky, ray.slope, ray.redshift};
}

namespace {

Crossing meeting(const RayTextures &tables, const LensEye &eye, vec3 azimuth, float sigma, float y,
		vec3 normal, int order) {
	const DiskSight sight =
			disk_sight(tables.forward, eye, lens_row(eye), disk_aim(eye, normal, azimuth), sigma, y, y);
	const DiskCrossing crossing = disk_crossing(tables.radius, sight, order);
	const float u = crossing.inverse_radius;
	const DiskClock clock = disk_clock(tables.radius, tables.delay, eye, sight);
	const float g =
			lens_redshift(eye, sigma) * lens_doppler(eye.celerity, lens_ray_direction(eye, azimuth, sigma));
	const bool reached = crossing.eta > 0.0F && crossing.eta < sight.way.span;
	return {reached, crossing.outgoing, u, crossing.chi, g / disk_orbit_frequency(u, sight.spin),
			g / disk_plunge_frequency(u, sight.way.a, sight.spin, crossing.outgoing),
			disk_delay(tables.delay, sight, clock, crossing, 1.0F / u)};
}

} // namespace

Crossing disk_meeting(const RayTextures &tables, vec3 place, vec3 view_direction, vec3 normal, int order,
		const Motion &motion) {
	const LensEye eye = lens_eye(place, motion.code, motion.parameters);
	const LensView view = lens_view(eye, effect_framed(eye, EFFECT_ALL, view_direction));
	const float sigma = eye.kappa * view.tan_half_xi;
	return meeting(tables, eye, view.azimuth, sigma, sigma - eye.sigma_c, normal, order);
}

Crossing disk_meeting_of_ray(const RayTextures &tables, float u, float y, vec3 azimuth, vec3 normal,
		int order, const Motion &motion) {
	const LensEye eye = lens_eye(vec3(0.0F, 0.0F, 1.0F / u), motion.code, motion.parameters);
	return meeting(tables, eye, azimuth, eye.sigma_c + y, y, normal, order);
}

float plunge_redshift(float u, float a, float spin, bool outgoing) {
	return 1.0F / disk_plunge_frequency(u, a, spin, outgoing);
}

float disk_temperature_share(float u, float plunging) {
	return disk_temperature(u, plunging);
}

} // namespace lensing_shader
