// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/observer_field.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

/// addons/blackhole_sky/shaders/{observer,lensing,effects}.gdshaderinc compiled as C++, behind plain
/// functions. A namespace of its own, because shading languages have one flat name space.
namespace lensing_shader {

/// A texture of RGBA texels as the shader sees it.
struct Texture {
	const std::vector<float> *texels;
	int columns;
};

/// How the observer moves, as the shader's uniforms say it (see observer.gdshaderinc).
struct Motion {
	int code = 0;
	glm::vec4 parameters{0.0F, 1.0F, 0.0F, 1.0F};
};
Motion motion_of(const blackhole::ObserverField &observer);

/// Every effect of effects.gdshaderinc.
inline constexpr int kAllEffects = 31;
inline constexpr int kAberration = 2;
inline constexpr int kDoppler = 8;

struct Ray {
	float clearance;
	float sigma;
	float slope;
};
struct Image {
	glm::vec3 direction;
	float magnification;
	float redshift;
};
struct RoughPlace {
	glm::vec3 direction;
	float error;               ///< radians
	float magnification_limit; ///< orders above 0
	float redshift_limit;
};
struct Sky {
	bool captured;
	glm::vec3 direction;
	float slope;
	float redshift;
};

/// Where a line of sight meets the plane of a disk.
struct Crossing {
	bool reached;
	bool outgoing; ///< light leaves the disk on its way out
	float inverse_radius;
	float angle;           ///< rad, between eye and crossing
	float redshift;        ///< nu_observed/nu_emitted of gas on the circular orbit there
	float plunge_redshift; ///< of gas that plunges from the last stable orbit
	float delay;           ///< r_s/c, Painleve-Gullstrand time from the crossing to the eye
};
struct RayTextures {
	Texture forward;
	Texture radius;
	Texture delay;
};

/// sigma_c at u.
float shadow_sigma(float u);
/// An orbital angle as the inverse table takes it: t(Phi) and dt/dPhi.
struct Angle {
	float t;
	float t_slope;
};
/// sigma - sigma_c, sigma and dsigma/dPhi from the inverse table.
Ray ray_of_angle(const Texture &inverse, float u, Angle angle);
/// The same for several angles, to as many rays.
void rays_of_angles(const Texture &inverse, float u, const Angle *angles, std::size_t count, Ray *rays);
/// Phi and dPhi/dy from the forward table.
glm::vec2 angle_of_ray(const Texture &forward, float u, float y);
/// Image of a star in the observer's own frame, with the effects (bits of effects.gdshaderinc) that are on.
Image star_image(const Texture &inverse, glm::vec3 place, glm::vec3 star, int order, const Motion &motion,
		float angular_radius, int effects);
/// About where that image is, how far off it may be and how large it is at most: by this the star layer
/// leaves out what is not in the picture, or too faint, before it reads the table.
RoughPlace rough_place(glm::vec3 place, glm::vec3 star, int order, const Motion &motion);
/// Where a viewing direction of the observer's own frame ends; the slope is dPhi/dxi in the radially moving
/// frame.
Sky trace(
		const Texture &forward, glm::vec3 place, glm::vec3 view_direction, const Motion &motion, int effects);

/// The meeting of this order of a viewing direction of the observer's own frame with the plane through the
/// hole whose unit normal is given.
Crossing disk_meeting(const RayTextures &tables, glm::vec3 place, glm::vec3 view_direction, glm::vec3 normal,
		int order, const Motion &motion);
/// The same of the ray sigma = sigma_c + y, on the side of `azimuth`, for a radially moving observer at (0,
/// 0, 1/u).
Crossing disk_meeting_of_ray(const RayTextures &tables, float u, float y, glm::vec3 azimuth, glm::vec3 normal,
		int order, const Motion &motion);
/// nu_infinity/nu_emitted of gas that plunges from the last stable orbit; `spin`: angular momentum over
/// energy of the light along -N, N being the axis about which the gas turns right-handedly.
float plunge_redshift(float u, float a, float spin, bool outgoing);
/// Temperature of the disk over that of its hottest ring.
float disk_temperature_share(float u, float plunging);

} // namespace lensing_shader
