// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/photometry/point_spread.h"
#include "core/relativity/observer_field.h"
#include "core/tables/lensing_shader.h"

/// Which shaders draw the sky: the dearer ones only where they are needed.
enum class SkyShaders {
	kFlat,    ///< as without hole and motion
	kRadial,  ///< static, rain and infall with every effect
	kGeneral, ///< any motion, any effects
	kMap,     ///< the same on a map of the whole sky
};

/// What the layers of a sky share: where the hole is, how observers move, how bright the picture is.
struct SkySettings {
	godot::Vector3 hole_position; ///< world
	godot::Basis sky_to_world;    ///< ICRS axes to world axes, a rotation
	double inverse_radius = 1.0;  ///< 1 / Schwarzschild radius, world units; meaningless when not lensing
	bool lensing = true;          ///< there is a hole
	SkyShaders shaders = SkyShaders::kRadial;
	blackhole::ObserverField observer;
	int effects = lensing_shader::kAllEffects; ///< bits of effects.gdshaderinc
	int projection = 0;                        ///< BlackHoleSky::Projection
	int overlays = 0;                          ///< bits of BlackHoleSky::Overlay
	double overlay_width = 1.5;                ///< pixels of a picture of 720 rows
	double exposure = 1.0;                     ///< linear factor, 2^EV
	double saturation = 1.0;                   ///< 0: grey, 1: as it is, above: exaggerated
	double stereo_baseline_scale = 1.0;        ///< of a headset's eyes, for the bending of light
	double see_through = 0.0;                  ///< how clear the sky is where light goes straight, 0 to 1
	blackhole::PointSpread psf_model = blackhole::PointSpread::kGaussian;
	double psf_sigma = 1.0;              ///< pixels
	double aperture = 0.005;             ///< metres
	double glare = blackhole::kEyeGlare; ///< share of the light in the eye's wings
	double faint_limit = 5e-5;           ///< peak luminance below which an image is not drawn
	double magnitude_limit = 99.0;       ///< V
	int image_orders = 2;
	uint32_t render_layers = 1;
};

/// The shaders look no closer [r_s].
inline constexpr double kNearestPlace = 1e-6;

/// A place (world) from the hole, in r_s and world axes; one at the hole is put kNearestPlace beside it.
glm::dvec3 place_in_radii(const SkySettings &settings, const glm::dvec3 &place);

/// Whether the room shows through the sky: maps show all of it as it is.
inline bool is_clear(const SkySettings &settings) {
	return settings.see_through > 0.0 && settings.shaders != SkyShaders::kMap;
}

/// Whether two settings have the same values for the uniforms that every layer has.
bool has_equal_uniforms(const SkySettings &a, const SkySettings &b);

/// Sets the uniforms of a material that every layer has.
void set_sky_uniforms(const godot::RID &material, const SkySettings &settings);
