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
#include "lensing_shader_source.inc" // lensing.gdshaderinc, see sources.cmake
#pragma GCC diagnostic pop

LensEye eye_at(float u) {
	return lens_eye(vec3(0.0F, 0.0F, 1.0F / u), LENS_MOTION_RAIN);
}

int motion_code(bool at_rest) {
	return at_rest ? LENS_MOTION_STATIC : LENS_MOTION_RAIN;
}

} // namespace

float shadow_sigma(float u) {
	return eye_at(u).sigma_c;
}

Ray ray_of_angle(const Texture &inverse, float u, float t, float t_slope) {
	const LensEye eye = eye_at(u);
	// The lines of lens_star_image() between its t and its sigma.
	const float q = sqrt(t * t + 2.0F * eye.w);
	const float q_table = sqrt(t * t + 2.0F * eye.w_table);
	const float s0 = t > 0.0F ? 0.5F * (t + q) : eye.w / (q - t);
	const float s_table = t > 0.0F ? 0.5F * (t + q_table) : eye.w_table / (q_table - t);
	const float big_x = clamp(log(s_table * inversesqrt(0.5F * eye.w_table)), -LENS_X_LIMIT, LENS_X_LIMIT);
	const vec2 column = lens_column(big_x);
	const LensSample ratio = lens_sample(inverse, lens_row(eye), column.x);
	const float clearance = s0 * ratio.value;
	const float slope = t_slope * s0 * (ratio.value / q + ratio.slope * column.y / q_table);
	return {clearance, eye.sigma_c + clearance, slope};
}

vec2 angle_of_ray(const Texture &forward, float u, float y) {
	const LensEye eye = eye_at(u);
	return lens_orbital_angle(forward, eye, lens_row(eye), y);
}

Image star_image(
		const Texture &inverse, vec3 place, vec3 star, int order, bool at_rest, float angular_radius) {
	const LensEye eye = lens_eye(place, motion_code(at_rest));
	const LensPath path = lens_path(eye, star, order);
	const LensImage image = lens_star_image(inverse, eye, lens_row(eye), path);
	return {image.direction, lens_magnification(eye, path, image, angular_radius),
			lens_redshift(eye, image.sigma)};
}

RoughPlace rough_place(vec3 place, vec3 star, int order, bool at_rest) {
	const LensEye eye = lens_eye(place, motion_code(at_rest));
	const LensPath path = lens_path(eye, star, order);
	const float sigma = lens_rough_sigma(eye, path);
	return {lens_direction(eye, path, sigma), lens_rough_error(eye),
			lens_magnification_limit(eye, path, 0.0F), lens_redshift_limit(eye, sigma)};
}

Sky trace(const Texture &forward, vec3 place, vec3 view_direction, bool at_rest) {
	const LensEye eye = lens_eye(place, motion_code(at_rest));
	const LensRay ray = lens_trace(forward, eye, lens_row(eye), view_direction);
	return {ray.clearance <= 0.0F, ray.sky, ray.slope, ray.redshift};
}

} // namespace lensing_shader
