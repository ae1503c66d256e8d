// SPDX-License-Identifier: MIT
#include "core/disk/plunging_gas.h"

#include "core/disk/page_thorne.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace blackhole {

double plunging_redshift(double r, const EmittedLight &light) {
	constexpr double kEnergySquared = 8.0 / 9.0;
	constexpr double kMomentum = std::numbers::sqrt3;
	if (!(r > 0.0 && r <= kInnermostStable) || (light.outgoing && r <= 1.0)) {
		return std::numeric_limits<double>::quiet_NaN();
	}
	const double u = 1.0 / r;
	const double height = 1.0 - u;
	const double energy = std::sqrt(kEnergySquared);
	// E^2 - (1 - u)(1 + L^2 u^2) = 3 (u - 1/3)^3
	const double fall = std::max((kInnermostStable - r) * u / kInnermostStable, 0.0);
	const double gas_across = 1.0 + kMomentum * kMomentum * u * u;
	const double light_across = u * u / (light.a * light.a);
	const double radial =
			std::sqrt(3.0 * fall * fall * fall) * std::sqrt(std::max(1.0 - height * light_across, 0.0));
	// (E -+ radial)/(1 - u), for light on its way in without the cancellation at the horizon.
	const double along = light.outgoing
			? (energy + radial) / height
			: (gas_across + light_across * (kEnergySquared - height * gas_across)) / (energy + radial);
	return 1.0 / (along + kMomentum * u * u * light.tilt / light.a);
}

} // namespace blackhole
