// SPDX-License-Identifier: MIT
#include "lut_cli/ray_columns.h"

#include "core/relativity/critical.h"
#include "core/relativity/deflection.h"
#include "core/relativity/light_ray.h"
#include "core/relativity/magnification.h"
#include "core/relativity/not_a_number.h"
#include "core/relativity/observer.h"
#include "core/relativity/redshift.h"
#include "core/relativity/shadow.h"
#include "core/relativity/view_angle.h"

#include <cmath>
#include <numbers>

namespace blackhole::ray_columns {
namespace {

/// xi, xi - xi_shadow, dxi/dPhi, mu, g for one observer; all nan where it does not exist.
struct View {
	double xi = kNaN;
	double beyond_shadow = kNaN;
	double slope = kNaN;
	double magnification = kNaN;
	double redshift = kNaN;
};

View view(double u, ImageDirection ray, ObserverMotion motion, double sin_phi) {
	const double kappa = radial_kappa(u, motion);
	if (!(kappa > 0.0)) {
		return {};
	}
	return {view_angle(u, ray.y, kappa), view_angle_beyond_shadow(u, ray.y, kappa),
			view_angle_slope(u, ray.y, kappa) * ray.slope, radial_magnification(u, ray, kappa, sin_phi),
			radial_redshift(u, ray.y, kappa)};
}

std::vector<double> forward(const RaySource &rays, std::span<const double> inputs, ObserverMotion motion) {
	const double u = inputs[0];
	const double xi = inputs[1];
	const bool rain = motion == ObserverMotion::kRain;
	const double kappa = radial_kappa(u, motion);
	const double y = rain ? rain_sigma_offset(u, xi) : static_sigma_offset(u, xi);
	std::vector<double> row{u, xi, kNaN, kNaN, kNaN, kNaN, kNaN};
	if (kappa > 0.0) {
		row[2] = view_angle_beyond_shadow(u, y, kappa);
		const LightRay<double> ray(u, y);
		const OrbitalAngle angle = rays.angle(u, y); // nan for captured rays
		row[3] = angle.phi;
		row[4] = angle.slope_y / view_angle_slope(u, y, kappa);
		row[5] = ray.a;
		row[6] = ray.sigma;
	}
	if (rain) {
		row.push_back(radial_redshift(u, y, kappa));
	}
	return row;
}

} // namespace

std::vector<double> inverse_rain(const RaySource &rays, std::span<const double> inputs) {
	const double u = inputs[0];
	const double phi = inputs[1];
	const ImageDirection image = rays.image(u, phi);
	const LightRay<double> ray(u, image.y);
	const View rain = view(u, image, ObserverMotion::kRain, std::abs(std::sin(phi)));
	return {u, phi, ray.sigma, image.y, ray.a, rain.xi, rain.beyond_shadow, rain.slope, rain.magnification,
			rain.redshift};
}

std::vector<double> inverse_static(const RaySource &rays, std::span<const double> inputs) {
	std::vector<double> row = inverse_rain(rays, inputs);
	const View rest = view(inputs[0], rays.image(inputs[0], inputs[1]), ObserverMotion::kStatic,
			std::abs(std::sin(inputs[1])));
	row.insert(row.end(), {rest.xi, rest.beyond_shadow, rest.slope, rest.magnification});
	return row;
}

std::vector<double> forward_static(const RaySource &rays, std::span<const double> inputs) {
	return forward(rays, inputs, ObserverMotion::kStatic);
}

std::vector<double> forward_rain(const RaySource &rays, std::span<const double> inputs) {
	return forward(rays, inputs, ObserverMotion::kRain);
}

std::vector<double> images(const RaySource &rays, std::span<const double> inputs) {
	const double u = inputs[0];
	const double star = inputs[1];
	const double order = inputs[2];
	const bool odd = std::fmod(order, 2.0) != 0.0;
	const double phi = odd ? (order + 1.0) * std::numbers::pi - star : order * std::numbers::pi + star;
	// A star straight away from the hole: the limit phi -> 0, to every digit.
	const double tiny = phi == 0.0 ? 1e-100 : 0.0;
	const ImageDirection ray = rays.image(u, phi + tiny);
	const double sin_phi = std::sin(star + tiny);
	const View rain = view(u, ray, ObserverMotion::kRain, sin_phi);
	const View rest = view(u, ray, ObserverMotion::kStatic, sin_phi);
	return {u, star, order, phi, odd ? -1.0 : 1.0, rain.xi, rain.magnification, rain.redshift, rest.xi,
			rest.magnification, rest.redshift};
}

std::vector<double> rings(const RaySource &rays, std::span<const double> inputs) {
	const double u = inputs[0];
	const ImageDirection ring = rays.image(u, inputs[1] * std::numbers::pi);
	const View rain = view(u, ring, ObserverMotion::kRain, 1.0);
	const View rest = view(u, ring, ObserverMotion::kStatic, 1.0);
	return {u, inputs[1], rain.xi, rain.beyond_shadow, rest.xi, LightRay<double>(u, ring.y).a};
}

std::vector<double> shadow(const RaySource & /*rays*/, std::span<const double> inputs) {
	return {inputs[0], shadow_half_angle(inputs[0], ObserverMotion::kRain),
			shadow_half_angle(inputs[0], ObserverMotion::kStatic)};
}

std::vector<double> deflection(const RaySource & /*rays*/, std::span<const double> inputs) {
	const Deflection result = blackhole::deflection(inputs[0]);
	return {inputs[0], result.beyond_critical, result.alpha, result.alpha_weak, result.alpha_strong,
			result.r_min};
}

std::vector<double> gshift(const RaySource & /*rays*/, std::span<const double> inputs) {
	const double u = inputs[0];
	const double xi = inputs[1];
	const double psi = inputs[2];
	std::vector<double> row{u, xi, psi, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
	if (!(u < 1.0)) {
		return row;
	}
	const double y = static_sigma_offset(u, xi);
	const double rain_kappa = radial_kappa(u, ObserverMotion::kRain);
	row[3] = radial_redshift(u, y, radial_kappa(u, ObserverMotion::kStatic));
	row[4] = view_angle(u, y, rain_kappa);
	row[5] = radial_redshift(u, y, rain_kappa);
	if (!(u < kPhotonSphereU)) {
		return row;
	}
	// In the static frame the orbit is a boost along e_phi, x here; z is outward.
	const double celerity = std::sqrt(u / (-3.0 * photon_sphere_offset(u)));
	const glm::dvec3 view(std::sin(xi) * std::cos(psi), std::sin(xi) * std::sin(psi), -std::cos(xi));
	const glm::dvec3 orbit(celerity, 0.0, 0.0);
	row[6] = std::sqrt(0.5 * u / (1.0 - u));
	row[7] = boost_direction(view, orbit).x;
	row[8] = row[3] * doppler_factor(view, orbit);
	return row;
}

} // namespace blackhole::ray_columns
