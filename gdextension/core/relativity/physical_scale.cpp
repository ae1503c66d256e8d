// SPDX-License-Identifier: MIT
#include "core/relativity/physical_scale.h"

#include <cmath>

namespace blackhole {

Outcome<PhysicalScale> PhysicalScale::of_mass(double mass_solar) {
	if (!(mass_solar > 0.0 && std::isfinite(mass_solar))) {
		return Outcome<PhysicalScale>::failure("the hole's mass must be a positive number of solar masses");
	}
	return Outcome<PhysicalScale>::success(
			PhysicalScale(mass_solar * (2.0 * kSolarMassParameter / (kSpeedOfLight * kSpeedOfLight))));
}

} // namespace blackhole
