// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/critical.h"

#include <cmath>

namespace blackhole {

/// One light ray through the observer at u = r_s/r, named by y = sigma - sigma_c, its distance from the
/// shadow's edge in the frame-free direction variable sigma = (a + u')/u. Every quantity here keeps its
/// relative precision for y -> 0, where a - a_c by subtraction would lose all digits.
template <class Real>
struct LightRay {
	Real u;
	Real y;
	Real sigma;
	/// Inverse impact parameter a = 1/b [1/r_s].
	Real a;
	/// a_c^2 - a^2: > 0 for rays with a turning point, 0 on the critical orbit.
	Real epsilon;
	/// du/dphi at the observer along the light's way in; < 0 if the backward ray first goes inward.
	Real u_slope;

	LightRay(const Real &observer_u, const Real &sigma_offset) : u(observer_u), y(sigma_offset) {
		const Real offset = photon_sphere_offset(u);
		const Real critical_slope = offset * critical_omega(u);
		sigma = critical_sigma(u) + y;
		// a - a_c = u (sigma - sigma_c)(sigma - sigma_c') / (2 sigma), and sigma_c - sigma_c' = 2 (u - 2/3)
		// om / u
		const Real a_offset = (y / sigma) * (0.5 * u * y + critical_slope);
		if (value_of(u) <= 1.0) {
			a = 0.5 * u * (sigma + (1.0 - u) / sigma);
		} else {
			a = kCriticalA + a_offset;
		}
		epsilon = -a_offset * (kCriticalA + a);
		if (std::abs(value_of(offset)) < kNearPhotonSphere) {
			u_slope = critical_slope + 0.5 * u * (y / sigma) * (sigma + outgoing_critical_sigma(u));
		} else {
			u_slope = 0.5 * u * (sigma - (1.0 - u) / sigma);
		}
	}

	/// Within this distance of u = 2/3 differences from the critical orbit are used.
	static constexpr double kNearPhotonSphere = 1.0 / 6.0;
};

} // namespace blackhole
