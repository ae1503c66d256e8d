// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/critical.h"

#include <cmath>
#include <numbers>

namespace blackhole {

/// The baseline S0(Phi, w): an elementary approximation of y = sigma - sigma_c as a function of the orbital
/// angle that has the right behaviour at both ends (Phi -> 0 and Phi -> infinity). The true y is S0 times a
/// smooth factor R between 0.4 and 1.1: R is what the tables store, and S0 starts the exact inversion.

/// w(u) = 2 a_c om_0 (1 + om_0)^2 sigma_c / (om (1 + om)^2); tends to u for far observers.
template <class Real>
Real baseline_width(const Real &u) {
	const Real omega = critical_omega(u);
	const Real shifted = 1.0 + omega;
	return 2.0 * kCriticalA * kFarOmegaFactor * critical_sigma(u) / (omega * shifted * shifted);
}

struct Baseline {
	/// S0.
	double s0 = 0.0;
	/// t(Phi): cot(Phi/2) up to pi, -sinh(Phi - pi)/2 beyond.
	double t = 0.0;
	/// dt/dPhi.
	double t_slope = 0.0;
	/// q = sqrt(t^2 + 2 w); dS0/dPhi = t_slope S0/q.
	double q = 0.0;
};

/// S0 and its slope at Phi [rad] > 0 for an observer with width w = baseline_width(u).
inline Baseline baseline(double w, double phi) {
	Baseline result;
	const double beyond = phi - std::numbers::pi;
	if (beyond <= 0.0) {
		result.t = 1.0 / std::tan(0.5 * phi);
		result.t_slope = -0.5 * (1.0 + result.t * result.t);
	} else {
		result.t = -0.5 * std::sinh(beyond);
		result.t_slope = -0.5 * std::cosh(beyond);
	}
	result.q = std::hypot(result.t, std::sqrt(2.0 * w)); // t may be as large as exp(300)
	result.s0 = result.t > 0.0 ? 0.5 * (result.t + result.q) : w / (result.q - result.t);
	return result;
}

/// The angle Phi [rad] at which the baseline has the value s0 > 0: the inverse of baseline().
inline double angle_of_baseline(double w, double s0) {
	const double t = s0 - 0.5 * w / s0;
	return t >= 0.0 ? 2.0 * std::atan2(1.0, t) : std::numbers::pi + std::asinh(-2.0 * t);
}

} // namespace blackhole
