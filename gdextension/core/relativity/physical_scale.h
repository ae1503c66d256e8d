// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"

namespace blackhole {

/// Speed of light [m/s], exact by the definition of the metre.
inline constexpr double kSpeedOfLight = 299792458.0;
/// Nominal solar mass parameter G M_sun [m^3/s^2] (IAU 2015 resolution B3).
inline constexpr double kSolarMassParameter = 1.3271244e20;
/// Standard gravity [m/s^2], exact by definition (3rd CGPM, 1901).
inline constexpr double kStandardGravity = 9.80665;

/// What the units r_s = 1 and c = 1 are for a hole of a given mass.
class PhysicalScale {
public:
	/// Fails unless mass_solar (in solar masses) is positive and finite.
	static Outcome<PhysicalScale> of_mass(double mass_solar);

	/// r_s = 2 G M/c^2 [m]: 2953.25 m a solar mass.
	[[nodiscard]] double metres() const { return metres_; }
	/// r_s/c [s]: 9.85 microseconds a solar mass.
	[[nodiscard]] double seconds() const { return metres_ / kSpeedOfLight; }
	/// c^2/r_s in units of standard gravity: multiply a proper acceleration [c^2/r_s] by it to have it in g.
	[[nodiscard]] double standard_gravities() const {
		return kSpeedOfLight * kSpeedOfLight / metres_ / kStandardGravity;
	}

private:
	explicit PhysicalScale(double metres) : metres_(metres) {}

	double metres_;
};

} // namespace blackhole
