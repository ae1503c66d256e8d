// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/observer.h"
#include "core/tables/lensing_shader.h"
#include "core/tables/lensing_tables.h"

#include <cstddef>

#include <glm/vec3.hpp>

namespace blackhole {

/// What the graphics shaders compute, on the CPU: the very source of addons/blackhole_sky/shaders/
/// lensing.gdshaderinc compiled as C++ in single precision, reading the same texels. For measuring the
/// tables' error and for tests; the exact functions are in core/relativity.
class ShaderLensing {
public:
	/// Keeps a reference: the tables must outlive this object.
	explicit ShaderLensing(const LensingTables &tables) : data(tables) {}

	/// sigma - sigma_c, sigma and dsigma/dPhi.
	using Ray = lensing_shader::Ray;
	/// The ray with orbital angle phi [rad] for the eye at u = r_s/r. The angle enters as the shader's t(Phi)
	/// and dt/dPhi, formed in double precision: rounding a star's direction to floats is not the table's
	/// error.
	[[nodiscard]] Ray ray_of_angle(double u, double phi) const;

	/// An orbital angle in those terms, which are the same for every eye.
	using TableAngle = lensing_shader::Angle;
	[[nodiscard]] static TableAngle table_angle(double phi);
	/// The rays of many angles for one eye, to as many places.
	void rays_of_angles(double u, const TableAngle *angles, std::size_t count, Ray *rays) const;

	struct Angle {
		/// Phi [rad] and dPhi/dy.
		float phi = 0.0F;
		float slope = 0.0F;
	};
	/// The orbital angle of the ray sigma = sigma_c + y, from the forward table.
	[[nodiscard]] Angle angle_of_ray(double u, double y) const;

	/// sigma_c as the shader has it.
	[[nodiscard]] static float shadow_sigma(double u);

	/// Unit direction, magnification and redshift in the observer's own frame.
	using Image = lensing_shader::Image;
	/// Image of order 0 to 3 of a star, all in single precision from place to result; position in r_s. The
	/// magnification is kept finite on the caustic by the star's angular radius [rad]. Only the given effects
	/// (bits of effects.gdshaderinc) are on.
	[[nodiscard]] Image star_image(glm::vec3 place, glm::vec3 star, int order, const ObserverField &observer,
			float angular_radius, int effects = lensing_shader::kAllEffects) const;

	/// About where the image is in the radially moving frame, without the tables, and the angle [rad] by
	/// which that may be wrong.
	using RoughPlace = lensing_shader::RoughPlace;
	[[nodiscard]] static RoughPlace rough_place(
			glm::vec3 place, glm::vec3 star, int order, const ObserverField &observer);

	/// Whether the ray is the hole's, and if not: the sky direction seen, dPhi/dxi in the radially moving
	/// frame, redshift.
	using Sky = lensing_shader::Sky;
	/// Where a viewing direction (observer's own frame) ends, all in single precision.
	[[nodiscard]] Sky trace(glm::vec3 place, glm::vec3 view_direction, const ObserverField &observer,
			int effects = lensing_shader::kAllEffects) const;

private:
	const LensingTables &data;
};

} // namespace blackhole
