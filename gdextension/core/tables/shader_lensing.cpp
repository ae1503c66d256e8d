// SPDX-License-Identifier: MIT
#include "core/tables/shader_lensing.h"

#include "core/relativity/baseline.h"

namespace blackhole {

ShaderLensing::Ray ShaderLensing::ray_of_angle(double u, double phi) const {
	return lensing_shader::ray_of_angle(
			{&data.inverse, data.columns}, static_cast<float>(u), table_angle(phi));
}

ShaderLensing::TableAngle ShaderLensing::table_angle(double phi) {
	const Baseline at = baseline(0.0, phi); // t and its slope depend on the angle only
	return {static_cast<float>(at.t), static_cast<float>(at.t_slope)};
}

void ShaderLensing::rays_of_angles(double u, const TableAngle *angles, std::size_t count, Ray *rays) const {
	lensing_shader::rays_of_angles({&data.inverse, data.columns}, static_cast<float>(u), angles, count, rays);
}

ShaderLensing::Angle ShaderLensing::angle_of_ray(double u, double y) const {
	const glm::vec2 angle = lensing_shader::angle_of_ray(
			{&data.forward, data.columns}, static_cast<float>(u), static_cast<float>(y));
	return {angle.x, angle.y};
}

float ShaderLensing::shadow_sigma(double u) {
	return lensing_shader::shadow_sigma(static_cast<float>(u));
}

ShaderLensing::Image ShaderLensing::star_image(glm::vec3 place, glm::vec3 star, int order,
		const ObserverField &observer, float angular_radius, int effects) const {
	return lensing_shader::star_image({&data.inverse, data.columns}, place, star, order,
			lensing_shader::motion_of(observer), angular_radius, effects);
}

ShaderLensing::RoughPlace ShaderLensing::rough_place(
		glm::vec3 place, glm::vec3 star, int order, const ObserverField &observer) {
	return lensing_shader::rough_place(place, star, order, lensing_shader::motion_of(observer));
}

ShaderLensing::Sky ShaderLensing::trace(
		glm::vec3 place, glm::vec3 view_direction, const ObserverField &observer, int effects) const {
	return lensing_shader::trace({&data.forward, data.columns}, place, view_direction,
			lensing_shader::motion_of(observer), effects);
}

} // namespace blackhole
