// SPDX-License-Identifier: MIT
#include "core/relativity/observer.h"

#include "core/relativity/redshift.h"
#include "core/relativity/shadow.h"
#include "core/relativity/view_angle.h"
#include "relativity/reference_data.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace blackhole::test {
namespace {

const std::vector<glm::dvec3> kDirections = {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.6, -0.8),
		glm::normalize(glm::dvec3(-1.0, 2.0, 0.5)), glm::normalize(glm::dvec3(-1.0, 1e-9, 0.0))};
const std::vector<glm::dvec3> kCelerities = {glm::dvec3(0.0), glm::dvec3(0.3, 0.0, 0.0),
		glm::dvec3(2.0, -1.0, 4.0), glm::dvec3(1e4, 0.0, 0.0), glm::dvec3(1e-9, 1e-9, 0.0)};

TEST(Boost, ComesBack) {
	for (const glm::dvec3 &celerity : kCelerities) {
		const double gamma = std::sqrt(1.0 + glm::dot(celerity, celerity));
		for (const glm::dvec3 &n : kDirections) {
			const glm::dvec3 moving = boost_direction(n, celerity);
			EXPECT_NEAR(glm::length(moving), 1.0, 1e-15);
			// Aberration squeezes by up to 2 gamma, and stretches rounding on the way back.
			EXPECT_LT(glm::length(boost_direction(moving, -celerity) - n), 1e-15 * 8.0 * gamma);
			const double there = doppler_factor(n, celerity);
			const double back = doppler_factor(moving, -celerity);
			EXPECT_LT(relative_error(there * back, 1.0), 1e-15 * 8.0 * gamma * gamma);
		}
	}
}

TEST(Boost, KeepsDigitsWhenReceding) {
	// Straight away at gamma beta = 1e8: D = 1/(gamma + gamma beta).
	EXPECT_LT(relative_error(doppler_factor(glm::dvec3(-1.0, 0.0, 0.0), glm::dvec3(1e8, 0.0, 0.0)), 5e-9),
			1e-15);
}

TEST(Boost, ChangesSolidAnglesByTheDopplerFactorSquared) {
	const glm::dvec3 celerity(0.4, -0.2, 0.9);
	for (const glm::dvec3 &n : kDirections) {
		const glm::dvec3 helper = std::abs(n.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
		const glm::dvec3 e1 = glm::normalize(glm::cross(n, helper));
		const glm::dvec3 e2 = glm::cross(n, e1);
		const double h = 1e-5;
		const auto along = [&](const glm::dvec3 &e) {
			return (boost_direction(glm::normalize(n + h * e), celerity) -
						   boost_direction(glm::normalize(n - h * e), celerity)) /
					(2.0 * h);
		};
		const double area = glm::length(glm::cross(along(e1), along(e2)));
		const double d = doppler_factor(n, celerity);
		EXPECT_LT(relative_error(area, 1.0 / (d * d)), 1e-8);
	}
}

TEST(ObserverCelerity, OfStaticObserversGivesTheirKappa) {
	// Seen across the boost from rain, every direction keeps sigma = kappa tan(xi/2).
	for (const double r : {1.001, 1.5, 3.0, 1e6}) {
		const glm::dvec3 outward = glm::normalize(glm::dvec3(1.0, -2.0, 0.5));
		const auto celerity = observer_celerity(ObserverMotion::kStatic, outward * r);
		ASSERT_TRUE(celerity);
		const double u = 1.0 / r;
		for (const double xi : {0.2, 1.3, 2.9}) {
			const glm::dvec3 across = glm::normalize(glm::cross(outward, glm::dvec3(0.0, 0.0, 1.0)));
			const glm::dvec3 rain = -outward * std::cos(xi) + across * std::sin(xi);
			const glm::dvec3 still = boost_direction(rain, *celerity.value);
			const double still_xi =
					2.0 * std::atan2(glm::length(still + outward), glm::length(still - outward));
			const double expected = radial_kappa(u, ObserverMotion::kRain) * std::tan(0.5 * xi);
			const double found = radial_kappa(u, ObserverMotion::kStatic) * std::tan(0.5 * still_xi);
			EXPECT_LT(relative_error(found, expected), 2e-12) << r << " " << xi;
		}
	}
}

TEST(ObserverCelerity, FailsWithAReason) {
	for (const glm::dvec3 &place : {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.5, 0.0), glm::dvec3(0.0)}) {
		const auto celerity = observer_celerity(ObserverMotion::kStatic, place);
		EXPECT_FALSE(celerity);
		EXPECT_FALSE(celerity.error.empty());
	}
	EXPECT_TRUE(observer_celerity(ObserverMotion::kRain, glm::dvec3(0.0, 0.5, 0.0)));
	EXPECT_FALSE(observer_celerity(
			ObserverMotion::kRain, glm::dvec3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0)));
	EXPECT_FALSE(orbit_celerity(glm::dvec3(1.5, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)));
	EXPECT_FALSE(orbit_celerity(glm::dvec3(0.0, 0.0, 5.0), glm::dvec3(0.0, 0.0, 1.0)));
}

TEST(Kappa, CoversEveryRadialMotion) {
	for (const double u : {1e-9, 0.3, 0.9}) {
		EXPECT_DOUBLE_EQ(infall_kappa(u, 1.0), radial_kappa(u, ObserverMotion::kRain));
		// The energy of rest: in and out are the same, the static observer.
		const double rest = std::sqrt(1.0 - u);
		EXPECT_NEAR(infall_kappa(u, rest), radial_kappa(u, ObserverMotion::kStatic), 2e-8);
		EXPECT_NEAR(outgoing_kappa(u, rest), radial_kappa(u, ObserverMotion::kStatic), 2e-8);
		EXPECT_NEAR(outgoing_kappa(u, 1.0), 1.0 - std::sqrt(u), 1e-15);
	}
	EXPECT_TRUE(std::isnan(outgoing_kappa(1.5, 1.0)));
	EXPECT_TRUE(std::isnan(radial_kappa(1.0, ObserverMotion::kStatic)));
	EXPECT_TRUE(std::isnan(infall_kappa(0.01, 0.5))); // bound below this height
}

TEST(RadialCelerity, IsTheBoostToThatKappa) {
	const glm::dvec3 place(0.0, 4.0, 0.0);
	const auto rest = radial_celerity(place, radial_kappa(0.25, ObserverMotion::kStatic));
	EXPECT_LT(glm::length(*rest.value - *observer_celerity(ObserverMotion::kStatic, place).value), 1e-15);
	// A probe shot inward with twice its rest energy, deep inside: same ray, same g by boost and by kappa.
	const glm::dvec3 inside(0.0, 0.25, 0.0);
	const double u = 4.0;
	const double kappa = infall_kappa(u, 2.0);
	const auto celerity = radial_celerity(inside, kappa);
	ASSERT_TRUE(celerity);
	EXPECT_LT(celerity.value->y, 0.0);
	const double y = 0.7;
	const double xi = view_angle(u, y, radial_kappa(u, ObserverMotion::kRain));
	const glm::dvec3 rain(std::sin(xi), -std::cos(xi), 0.0);
	const glm::dvec3 probe = boost_direction(rain, *celerity.value);
	EXPECT_NEAR(std::atan2(probe.x, -probe.y), view_angle(u, y, kappa), 1e-14);
	const double g = radial_redshift(u, y, radial_kappa(u, ObserverMotion::kRain));
	EXPECT_LT(relative_error(g * doppler_factor(rain, *celerity.value), radial_redshift(u, y, kappa)), 1e-14);
	EXPECT_FALSE(radial_celerity(place, std::numeric_limits<double>::quiet_NaN()));
	EXPECT_FALSE(radial_celerity(glm::dvec3(0.0), 1.0));
}

TEST(Redshift, OfOneRayForThreeObservers) {
	const ReferenceData data("gshift");
	const auto u = data.column("u_o");
	const auto xi_static = data.column("xi_static");
	const auto psi = data.column("psi");
	const auto g_static = data.column("g_static");
	const auto xi_rain = data.column("xi_rain");
	const auto g_rain = data.column("g_rain");
	const auto along = data.column("d1");
	const auto g_circ = data.column("g_circ");
	for (std::size_t i = 0; i < data.size(); ++i) {
		const double kappa = radial_kappa(u[i], ObserverMotion::kRain);
		// Above u = 2/3 - 1e-3 the orbit's celerity amplifies the rounding of u.
		const double tolerance = 1e-14 / (2.0 - 3.0 * u[i]);
		const double y = static_sigma_offset(u[i], xi_static[i]);
		EXPECT_LT(relative_error(view_angle(u[i], y, kappa), xi_rain[i]), 1e-14);
		EXPECT_LT(relative_error(radial_redshift(u[i], y, kappa), g_rain[i]), 1e-14);
		EXPECT_LT(relative_error(
						  radial_redshift(u[i], y, radial_kappa(u[i], ObserverMotion::kStatic)), g_static[i]),
				1e-14);
		// Outward x, orbital velocity y.
		const glm::dvec3 view(-std::cos(xi_rain[i]), std::sin(xi_rain[i]) * std::cos(psi[i]),
				std::sin(xi_rain[i]) * std::sin(psi[i]));
		const auto orbit = orbit_celerity(glm::dvec3(1.0 / u[i], 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0));
		ASSERT_TRUE(orbit);
		const double g = g_rain[i] * doppler_factor(view, *orbit.value);
		EXPECT_LT(relative_error(g, g_circ[i]), tolerance) << i;
		// The static frame differs from rain by a boost along x, whose axes the orbiting frame inherits
		// turned by Wigner's rotation; the cosine to the orbital velocity is compared in the static
		// observer's boost.
		const double v = 1.0 / std::sqrt(2.0 / u[i] - 2.0);
		const double gamma = 1.0 / std::sqrt(1.0 - v * v);
		const glm::dvec3 still(-std::cos(xi_static[i]), std::sin(xi_static[i]) * std::cos(psi[i]),
				std::sin(xi_static[i]) * std::sin(psi[i]));
		EXPECT_NEAR(boost_direction(still, glm::dvec3(0.0, gamma * v, 0.0)).y, along[i], tolerance) << i;
	}
}

TEST(Shadow, HasTheKnownSizes) {
	const double degrees = 180.0 / std::numbers::pi;
	EXPECT_NEAR(2.0 * shadow_half_angle(1.0, ObserverMotion::kRain) * degrees, 84.2068977, 5e-8);
	EXPECT_NEAR(2.0 * shadow_half_angle(1.0 / 1.5, ObserverMotion::kStatic) * degrees, 180.0, 1e-12);
	EXPECT_NEAR(shadow_half_angle(0.1, ObserverMotion::kStatic) * degrees, 14.2690273279, 5e-11);
	EXPECT_TRUE(std::isnan(shadow_half_angle(1.0, ObserverMotion::kStatic)));
}

} // namespace
} // namespace blackhole::test
