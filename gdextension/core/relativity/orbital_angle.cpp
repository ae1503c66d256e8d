// SPDX-License-Identifier: MIT
#include "core/relativity/orbital_angle.h"

#include "core/relativity/carlson.h"
#include "core/relativity/light_ray.h"
#include "core/relativity/not_a_number.h"
#include "core/relativity/orbit_cubic.h"

#include <cmath>

namespace blackhole {
namespace {

/// Integral of du/sqrt(P) from 0 to the turning point u_2, where P vanishes: Carlson's two-point formula has
/// U_23^2 = u_3 (u_2 - u_1)/u_2, U_12^2 = w (u_3 - u_2)/u_2, U_13^2 = (u_2 - u_1)(u_3 - u_2)/u_2.
template <class Real>
Real angle_to_turning_point(const Real &a, const OrbitCubic<Real> &cubic) {
	using std::sqrt;
	const Real u2 = cubic.turning_point(a);
	const Real gap = sqrt(cubic.gap_squared);
	const Real u3 = u2 + gap;
	const Real reach = u2 + cubic.w;
	const Real root_sum = sqrt(cubic.w) + sqrt(reach);
	return 2.0 * sqrt(u2) *
			carlson_rf_pair<Real>(u3 * reach, gap * root_sum * root_sum, gap * sqrt(cubic.w * reach));
}

/// Integral of du/sqrt(P) from 0 to u along a piece on which u' keeps its sign; slope_size = |u'| at u.
/// With X_i = sqrt|u - u_i|, Y_i = sqrt|u_i|: U_23 = (f Y_1 + g X_1)/u, f = X_2 X_3, g = Y_2 Y_3, and
/// (U_12 + U_13)^2 = (X_1 + Y_1)^2 (E + 2 f g)/u^2, E = 2 g^2 - u (u_2 + u_3): smooth through a = a_c.
template <class Real>
Real monotonic_angle(const Real &u, const Real &slope_size, const Real &a, const OrbitCubic<Real> &cubic) {
	using std::sqrt;
	const Real x1 = sqrt(u + cubic.w);
	const Real y1 = sqrt(cubic.w);
	const Real f = slope_size / x1;
	const Real g = a / y1;
	const Real u23 = (f * y1 + g * x1) / u;
	const Real v = photon_sphere_offset(u);
	const bool near = std::abs(value_of(v)) < LightRay<Real>::kNearPhotonSphere;
	const Real e = near
			? (kPhotonSphereU - v) * cubic.offset_sum + 2.0 * cubic.offset_product - (4.0 / 3.0) * v
			: 2.0 * g * g - u * (1.0 + cubic.w);
	const Real fg = 2.0 * f * g;
	// (2 f g)^2 - E^2 = -u^2 (u_3 - u_2)^2 avoids the difference of nearly equal terms.
	const bool cancels = value_of(e) < 0.0 && value_of(cubic.gap_squared) < 0.0;
	const Real spread = cancels ? -cubic.gap_squared / (fg - e) : (e + fg) / (u * u);
	const Real ends = x1 + y1;
	const Real sum = ends * ends * spread;
	const Real product = 0.5 * fg / (ends * ends) + x1 * y1 * spread;
	return 2.0 * carlson_rf_pair<Real>(u23 * u23, sum, product);
}

template <class Real>
Real total_angle(const Real &u, const Real &y) {
	const LightRay<Real> ray(u, y);
	const OrbitCubic<Real> cubic(ray.a, ray.epsilon);
	if (value_of(ray.u_slope) >= 0.0 || value_of(cubic.gap_squared) <= 0.0) {
		return monotonic_angle(u, ray.u_slope, ray.a, cubic);
	}
	// In to the turning point and out again: twice the whole arm less the part beyond the observer.
	return 2.0 * angle_to_turning_point(ray.a, cubic) - monotonic_angle<Real>(u, -ray.u_slope, ray.a, cubic);
}

bool in_range(double u, double y) {
	return u > 0.0 && y > 0.0 && std::isfinite(u) && std::isfinite(y);
}

} // namespace

double orbital_angle(double u, double y) {
	return in_range(u, y) ? total_angle<double>(u, y) : kNaN;
}

OrbitalAngle orbital_angle_slope(double u, double y) {
	if (!in_range(u, y)) {
		return {kNaN, kNaN, kNaN};
	}
	const auto result = total_angle<Dual<1>>(Dual<1>(u), Dual<1>::variable(y, 0));
	return {result.value, result.slope[0], 0.0};
}

OrbitalAngle orbital_angle_slopes(double u, double y) {
	if (!in_range(u, y)) {
		return {kNaN, kNaN, kNaN};
	}
	const auto result = total_angle<Dual<2>>(Dual<2>::variable(u, 1), Dual<2>::variable(y, 0));
	return {result.value, result.slope[0], result.slope[1]};
}

double angle_to_turning_point(double a, double epsilon) {
	return a > 0.0 && epsilon > 0.0 ? angle_to_turning_point<double>(a, OrbitCubic<double>(a, epsilon))
									: kNaN;
}

} // namespace blackhole
