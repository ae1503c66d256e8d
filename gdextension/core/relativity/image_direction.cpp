// SPDX-License-Identifier: MIT
#include "core/relativity/image_direction.h"

#include "core/relativity/baseline.h"
#include "core/relativity/not_a_number.h"
#include "core/relativity/orbital_angle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blackhole {

ImageDirection image_direction(double u, double phi) {
	if (!(u > 0.0 && std::isfinite(u) && phi > 0.0 && phi <= 300.0)) {
		return {kNaN, kNaN};
	}
	const double w = baseline_width(u);
	const Baseline aim = baseline(w, phi);
	double low = 0.0;
	double high = std::numeric_limits<double>::infinity();
	double y = 0.8 * aim.s0;
	double last_change = high;
	OrbitalAngle angle;
	for (int step = 0; step < 60; ++step) {
		angle = orbital_angle_slope(u, y);
		const double miss = angle.phi - phi;
		(miss > 0.0 ? low : high) = y; // Phi falls with y
		// ln S0(Phi(y)) is nearly ln y plus a constant: Newton's method on that, not on Phi itself.
		const Baseline here = baseline(w, angle.phi);
		const double here_slope = here.t_slope / here.q;
		const double log_step = (std::abs(miss) < 1e-3 * phi)
				? miss / (angle.slope_y * y)
				: std::log(here.s0 / aim.s0) / (here_slope * angle.slope_y * y);
		double next = y * std::exp(std::clamp(-log_step, -2.0, 2.0));
		if (!(next >= low && next <= high)) {
			next = std::sqrt(low * high);
		}
		const double change = std::abs(next / y - 1.0);
		y = next;
		// Quadratic convergence: below 1e-13 nothing is left; where Phi itself is rounded more coarsely than
		// that (far observers looking past the hole) the steps stop shrinking instead.
		if (change < 1e-13 || (change < 1e-7 && change >= 0.25 * last_change)) {
			break;
		}
		last_change = change;
	}
	return {y, 1.0 / angle.slope_y};
}

} // namespace blackhole
