// SPDX-License-Identifier: MIT
#pragma once

#include "core/photometry/planck_table.h"
#include "core/relativity/observer_field.h"
#include "core/tables/lensing_tables.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// A glowing disk, as far as its light in all is concerned: without turbulence and limb darkening.
struct GlowingDisk {
	glm::dvec3 normal{0.0, 1.0, 0.0};  ///< unit vector, world axes
	bool retrograde = false;           ///< the gas turns left-handedly about it
	double outer_radius = 15.0;        ///< of the disk's own r_s
	double hole_scale = 1.0;           ///< the hole's r_s over the disk's own
	double peak_temperature = 6500.0;  ///< K, of the hottest ring
	double plunging_temperature = 0.0; ///< of gas within the last stable orbit, over that; 0: none
	double opacity = 1.0;
	double log2_brightness = 0.0; ///< picture luminance = 2^(log2 Y[cd/m2] + this)
	int orders = 3;
};

/// What a line of sight gets from a disk.
struct DiskGlow {
	double luminance = 0.0; ///< of the picture
	double through = 1.0;   ///< share of the light behind that comes through
};

/// The disk's light in `view_direction` (the observer's own frame, unit vector) at `place` (from the hole,
/// r_s), by the shader's own crossings in single precision. For meters: pixels are drawn by
/// accretion_disk.gdshaderinc.
DiskGlow disk_glow(const LensingTables &tables, const PlanckTable &planck, const GlowingDisk &disk,
		const glm::dvec3 &place, const glm::dvec3 &view_direction, const ObserverField &observer);

} // namespace blackhole
