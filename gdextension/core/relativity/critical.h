// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/dual.h"

#include <cmath>
#include <numbers>

namespace blackhole {

/// Facts of the critical orbit, the light ray that winds round the photon sphere u = 2/3 for ever.
/// Lengths are in Schwarzschild radii; u = r_s/r. The templates take double or Dual.

inline constexpr double kSqrt3 = std::numbers::sqrt3;
/// Critical inverse impact parameter a_c = 2/(3 sqrt 3) [1/r_s].
inline constexpr double kCriticalA = 2.0 / (3.0 * kSqrt3);
/// Critical impact parameter b_c = 3 sqrt(3)/2 [r_s]: the nearest double, and the rest that rounding cut off
/// it.
inline constexpr double kCriticalB = 2.598076211353316;
inline constexpr double kCriticalBRest = -7.151834159776797e-17;
/// Inverse radius of the photon sphere: the nearest double, and the rest that rounding cut off it.
inline constexpr double kPhotonSphereU = 2.0 / 3.0;
inline constexpr double kPhotonSphereURest = 3.700743415417188e-17;

/// u - 2/3 to full relative precision: near the photon sphere Phi depends on the ratio of y to this.
template <class Real>
Real photon_sphere_offset(const Real &u) {
	return (u - kPhotonSphereU) - kPhotonSphereURest;
}

/// om(u) = sqrt(u + 1/3): the critical orbit has du/dphi = (u - 2/3) om.
template <class Real>
Real critical_omega(const Real &u) {
	using std::sqrt;
	return sqrt(u + 1.0 / 3.0);
}

/// sigma_c(u), the direction variable sigma at the shadow's edge; analytic through u = 2/3 and u = 1.
template <class Real>
Real critical_sigma(const Real &u) {
	const Real slope = photon_sphere_offset(u) * critical_omega(u);
	if (value_of(u) < kPhotonSphereU) {
		return u * (1.0 - u) / (kCriticalA - slope);
	}
	return (kCriticalA + slope) / u;
}

/// The other root sigma_c' of a(sigma) = a_c: the outgoing critical ray; sigma_c sigma_c' = 1 - u.
template <class Real>
Real outgoing_critical_sigma(const Real &u) {
	if (value_of(u) < kPhotonSphereU) {
		return (kCriticalA - photon_sphere_offset(u) * critical_omega(u)) / u;
	}
	return (1.0 - u) / critical_sigma(u);
}

/// sigma - sigma_c -> sigma_c kEdgeConstant exp(-Phi) / (om (1 + om)^2) for Phi -> infinity.
/// = 216 (7 - 4 sqrt 3) om_0 (1 + om_0)^2 with om_0 = 1/sqrt 3 (Darwin's strong-deflection limit seen from
/// u).
inline constexpr double kFarOmegaFactor = (1.0 / kSqrt3) * (1.0 + 1.0 / kSqrt3) * (1.0 + 1.0 / kSqrt3);
inline constexpr double kEdgeConstant = 216.0 / (7.0 + 4.0 * kSqrt3) * kFarOmegaFactor;

} // namespace blackhole
