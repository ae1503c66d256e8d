// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/observer.h"
#include "core/tables/lensing_shader.h"
#include "core/tables/lensing_tables.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// Where lines of sight meet a disk, as the graphics shaders compute it, on the CPU and in single precision:
/// the very source of addons/blackhole_sky/shaders/disk_crossing.gdshaderinc, reading the same texels. The
/// exact functions are in core/disk.
class ShaderDisk {
public:
	/// Keeps a reference: the tables must outlive this object.
	explicit ShaderDisk(const LensingTables &tables) : data(tables) {}

	using Crossing = lensing_shader::Crossing;
	/// The meeting of this order (0, 1, ...) of a viewing direction (observer's own frame) with the plane of
	/// this unit normal through the hole; place in r_s.
	[[nodiscard]] Crossing crossing(glm::vec3 place, glm::vec3 view_direction, glm::vec3 normal, int order,
			const ObserverField &observer) const;

	/// The same of the ray sigma = sigma_c + y, for an observer at (0, 0, 1/u) who rests or moves along the
	/// radius; `azimuth`: unit vector across the line to the hole. The ray enters in double precision:
	/// rounding a direction is not the tables' error.
	[[nodiscard]] Crossing crossing_of_ray(double u, double y, glm::vec3 azimuth, glm::vec3 normal, int order,
			const ObserverField &observer) const;

private:
	[[nodiscard]] lensing_shader::RayTextures textures() const;

	const LensingTables &data;
};

} // namespace blackhole
