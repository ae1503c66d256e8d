// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/vector3.hpp>

/// What the layers of a sky share: where the hole is, how observers move, how bright the picture is.
struct SkySettings {
	godot::Vector3 hole_position;  ///< world
	godot::Basis sky_to_world;     ///< ICRS axes to world axes, a rotation
	double inverse_radius = 1.0;   ///< 1 / Schwarzschild radius, world units; meaningless when not lensing
	bool lensing = true;           ///< false: the sky as without the hole
	int observer_motion = 0;       ///< LensingTable::Motion
	double exposure = 1.0;         ///< linear factor, 2^EV
	double psf_sigma = 1.0;        ///< pixels
	double faint_limit = 5e-5;     ///< peak luminance below which an image is not drawn
	double magnitude_limit = 99.0; ///< V
	int image_orders = 2;
	uint32_t render_layers = 1;
};
