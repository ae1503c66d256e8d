// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include <godot_cpp/classes/cubemap.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/texture2d.hpp>

#include <glm/vec3.hpp>

#include "core/catalogue/star.h"
#include "core/photometry/planck_table.h"
#include "core/photometry/sky_brightness.h"

/// The mean light of each part of the sky as it is drawn, stars and panorama or cube map, for the exposure
/// meter. The maps are made when they are first asked for: stars take 0.1 s a million, a picture is read back
/// from the graphics card once.
class SkyLight {
public:
	/// Which light the sky has; what is null gives none.
	struct Sources {
		const blackhole::StarTable *stars = nullptr;
		double magnitude_limit = 99.0; ///< V
		godot::Ref<godot::Texture2D> panorama;
		godot::Ref<godot::Cubemap> cubemap; ///< instead of a panorama
		double panorama_luminance = 1.0;    ///< of a texel of value 1
		bool panorama_is_light = true;      ///< shifted in frequency
	};

	/// The table of stars holds others than before.
	void forget_stars() { stars.reset(); }
	/// Makes the maps that these sources need.
	void use(const Sources &sources);

	/// Luminance at exposure 0 in a direction (sky axes) with every frequency multiplied by `shift`.
	double luminance(const glm::dvec3 &direction, double shift) const;

private:
	struct StarMap {
		const blackhole::StarTable *table = nullptr;
		double magnitude_limit = 0.0;
		blackhole::SkyBrightness light;
	};
	struct PanoramaMap {
		uint64_t texture = 0;
		blackhole::SkyBrightness light;
	};
	double shifted(const blackhole::SkyBrightness::Light &light, double shift) const;

	std::unique_ptr<StarMap> stars;
	std::unique_ptr<PanoramaMap> panorama;
	std::unique_ptr<blackhole::PlanckTable> planck;
	bool stars_shown = false;
	bool panorama_shown = false;
	double panorama_luminance = 1.0;
	bool panorama_is_light = true;
};
