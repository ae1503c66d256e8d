// SPDX-License-Identifier: MIT
#include "core/culling/image_bound.h"

#include "core/relativity/critical.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace blackhole {
namespace {

// R of the tables lies between its edge value 0.4353 and 1, and rises with S0: |dsigma/dPhi| stays below this
// many times the slope of S0 itself.
constexpr double kEdgeRatio = 0.4353;
constexpr double kSlopeReserve = 1.3;
// w of the tables (PHYSICS of lut/README.md): S0 = (t + sqrt(t^2 + 2 w))/2.
constexpr double kEdgeScale = 1.1057928318722599;

/// S0 and |dS0/dPhi| at the orbital angle phi > 0.
struct ScaleAt {
	double s0 = 0.0;
	double slope = 0.0;
};

ScaleAt scale_at(double phi, double w) {
	double t = 0.0;
	double t_slope = 0.0;
	if (phi <= std::numbers::pi) {
		t = 1.0 / std::tan(0.5 * phi);
		t_slope = 0.5 * (1.0 + t * t);
	} else {
		const double d = phi - std::numbers::pi;
		t = -0.5 * std::sinh(d);
		t_slope = 0.5 * std::cosh(d);
	}
	const double q = std::sqrt(t * t + 2.0 * w);
	const double s0 = t > 0.0 ? 0.5 * (t + q) : w / (q - t);
	return {s0, s0 * t_slope / q};
}

/// log2 of Y(g T) / (g^2 Y(T)): with mu g^2, the same for all observers, it gives the image's brightness.
double shift_gain(double g, double temperature, const PlanckTable &planck) {
	return planck.log2_luminance(g * temperature) - planck.log2_luminance(temperature) - 2.0 * std::log2(g);
}

double redshift_of(const EyeBound &eye, double sigma) {
	if (eye.is_static) {
		return 1.0 / std::sqrt(1.0 - eye.u);
	}
	const double k2 = eye.kappa * eye.kappa;
	const double s2 = sigma * sigma;
	return 1.0 / (1.0 - std::sqrt(eye.u) * (k2 - s2) / (k2 + s2));
}

} // namespace

EyeBound eye_bound(const glm::dvec3 &position, ObserverMotion motion) {
	EyeBound eye;
	const double r = glm::length(position);
	eye.outward = position / r;
	eye.u = 1.0 / r;
	eye.is_static = motion == ObserverMotion::kStatic && eye.u < 1.0;
	eye.kappa = eye.is_static ? std::sqrt(1.0 - eye.u) : 1.0 + std::sqrt(eye.u);
	eye.sigma_c = critical_sigma(eye.u);
	const double om = critical_omega(eye.u);
	eye.w = kEdgeScale * eye.sigma_c / (om * (1.0 + om) * (1.0 + om));
	return eye;
}

double brightest_image_magnitude(
		const EyeBound &eye, const StarGroup &group, int order, double slack, const PlanckTable &planck) {
	constexpr double kPi = std::numbers::pi;
	const double angle = std::acos(std::clamp(glm::dot(eye.outward, group.centre), -1.0, 1.0));
	const double reach = group.angular_radius + slack;
	const double phi_low = std::max(angle - reach, 0.0);
	const double phi_high = std::min(angle + reach, kPi);
	const double sin_phi =
			phi_low <= 0.0 || phi_high >= kPi ? 0.0 : std::min(std::sin(phi_low), std::sin(phi_high));
	// Order 0 alone has no caustic in front of the hole (phi = 0).
	if (order > 0 ? sin_phi <= 0.0 : phi_high >= kPi) {
		return -std::numeric_limits<double>::infinity();
	}

	const double turns = kPi * static_cast<double>(order + (order % 2));
	const double near_phi = order % 2 == 1 ? turns - phi_high : turns + phi_low; // shorter way round
	const double far_phi = order % 2 == 1 ? turns - phi_low : turns + phi_high;
	const double k2 = eye.kappa * eye.kappa;
	double magnification = 0.0;
	double sigma_near = 0.0;
	double sigma_far = 0.0;
	if (order == 0) {
		// A smooth function of phi: the ends and the middle bound it, with sigma anywhere between the
		// extremes of R.
		const double first = std::max(near_phi, 1e-3);
		for (const double phi : {first, 0.5 * (first + far_phi), far_phi}) {
			const ScaleAt scale = scale_at(phi, eye.w);
			const double sigma_low = eye.sigma_c + kEdgeRatio * scale.s0;
			const double sum = k2 + sigma_low * sigma_low;
			const double mu = 4.0 * k2 * (eye.sigma_c + scale.s0) * scale.slope / (sum * sum);
			magnification = std::max(magnification, 2.0 * kSlopeReserve * mu / std::sin(phi));
		}
		sigma_near = eye.sigma_c + scale_at(first, eye.w).s0;
		sigma_far = eye.sigma_c + kEdgeRatio * scale_at(far_phi, eye.w).s0;
	} else {
		const ScaleAt scale = scale_at(near_phi, eye.w);
		sigma_near = eye.sigma_c + scale.s0;
		sigma_far = eye.sigma_c;
		const double sum = k2 + sigma_far * sigma_far;
		magnification = kSlopeReserve * 4.0 * k2 * sigma_near * scale.slope / (sum * sum * sin_phi);
	}
	const double g_near = redshift_of(eye, sigma_near);
	const double g_far = redshift_of(eye, sigma_far);
	double gain = -std::numeric_limits<double>::infinity();
	for (const double g : {g_near, g_far}) {
		for (const double temperature : {group.coolest_k, group.hottest_k}) {
			gain = std::max(gain, shift_gain(g, temperature, planck));
		}
	}
	const double g_large = std::max(g_near, g_far);
	gain += std::log2(magnification * g_large * g_large);
	return static_cast<double>(group.brightest_v) - 2.5 * std::numbers::ln2 / std::numbers::ln10 * gain;
}

} // namespace blackhole
