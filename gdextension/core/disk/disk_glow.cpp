// SPDX-License-Identifier: MIT
#include "core/disk/disk_glow.h"

#include "core/disk/page_thorne.h"
#include "core/tables/shader_disk.h"

#include <algorithm>
#include <cmath>

namespace blackhole {

DiskGlow disk_glow(const LensingTables &tables, const PlanckTable &planck, const GlowingDisk &disk,
		const glm::dvec3 &place, const glm::dvec3 &view_direction, const ObserverField &observer) {
	const ShaderDisk shader(tables);
	// A disk that turns left-handedly is one that turns right-handedly about the opposite normal.
	const glm::vec3 axis(disk.retrograde ? -disk.normal : disk.normal);
	const bool plunges = disk.plunging_temperature > 0.0;
	DiskGlow glow;
	for (int order = 0; order < disk.orders && glow.through > 1e-3; ++order) {
		const ShaderDisk::Crossing crossing =
				shader.crossing(glm::vec3(place), glm::vec3(view_direction), axis, order, observer);
		if (!crossing.reached || !(crossing.inverse_radius > 0.0F)) {
			continue;
		}
		const double r = disk.hole_scale / double{crossing.inverse_radius};
		const bool orbits = r >= kInnermostStable;
		if (r > disk.outer_radius || (!orbits && (!plunges || (crossing.outgoing && r <= 1.0)))) {
			continue;
		}
		const double share = r < kHottestRing
				? std::max(page_thorne_temperature(r), disk.plunging_temperature)
				: page_thorne_temperature(r);
		const double shift = orbits ? double{crossing.redshift} : double{crossing.plunge_redshift};
		const double seen = share * disk.peak_temperature * shift;
		if (seen > 0.0) {
			glow.luminance += glow.through * disk.opacity *
					std::exp2(planck.log2_luminance(seen) + disk.log2_brightness);
		}
		glow.through *= 1.0 - disk.opacity;
	}
	return glow;
}

} // namespace blackhole
