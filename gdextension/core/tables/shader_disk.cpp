// SPDX-License-Identifier: MIT
#include "core/tables/shader_disk.h"

namespace blackhole {

lensing_shader::RayTextures ShaderDisk::textures() const {
	return {{&data.forward, data.columns}, {&data.ray_texels.radius, kRayTexelColumns},
			{&data.ray_texels.delay, kRayTexelColumns}};
}

ShaderDisk::Crossing ShaderDisk::crossing(glm::vec3 place, glm::vec3 view_direction, glm::vec3 normal,
		int order, const ObserverField &observer) const {
	return lensing_shader::disk_meeting(
			textures(), place, view_direction, normal, order, lensing_shader::motion_of(observer));
}

ShaderDisk::Crossing ShaderDisk::crossing_of_ray(double u, double y, glm::vec3 azimuth, glm::vec3 normal,
		int order, const ObserverField &observer) const {
	return lensing_shader::disk_meeting_of_ray(textures(), static_cast<float>(u), static_cast<float>(y),
			azimuth, normal, order, lensing_shader::motion_of(observer));
}

} // namespace blackhole
