// SPDX-License-Identifier: MIT
#include "core/relativity/star_image.h"

#include "core/relativity/shadow.h"
#include "relativity/reference_data.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace blackhole::test {
namespace {

using std::numbers::pi;

/// An oblique set of axes: outward, and two across it.
const glm::dvec3 kOutward = glm::normalize(glm::dvec3(0.3, -0.7, 0.5));
const glm::dvec3 kAcross = glm::normalize(glm::cross(kOutward, glm::dvec3(0.0, 1.0, 0.2)));

glm::dvec3 star_at(double phi) {
	return kOutward * std::cos(phi) + kAcross * std::sin(phi);
}

StarImage image_of(double r, double phi, int order, ObserverMotion motion) {
	const auto image = star_image(kOutward * r, star_at(phi), order, motion);
	EXPECT_TRUE(image) << image.error;
	return *image.value;
}

TEST(StarImage, AgreesWithTheReferenceImages) {
	const ReferenceData data("images");
	const auto u = data.column("u_o");
	const auto phi = data.column("phi");
	const auto order = data.column("order");
	const auto side = data.column("side");
	for (const ObserverMotion motion : {ObserverMotion::kRain, ObserverMotion::kStatic}) {
		const bool rain = motion == ObserverMotion::kRain;
		const auto xi = data.column(rain ? "xi_rain" : "xi_static");
		const auto mu = data.column(rain ? "mu_rain" : "mu_static");
		const auto g = data.column(rain ? "g_rain" : "g_static");
		for (std::size_t i = 0; i < data.size(); ++i) {
			if (std::isnan(xi[i])) {
				EXPECT_FALSE(star_image(kOutward / u[i], star_at(phi[i]), 0, motion));
				continue;
			}
			const StarImage image = image_of(1.0 / u[i], phi[i], static_cast<int>(order[i]), motion);
			// The star's direction is rounded to 1e-16 rad; the image moves by dxi/dPhi ~ sqrt(mu) times
			// that, and a place near the horizon is known to 1e-16/(1 - u).
			const double place = rain ? 0.0 : 4e-16 / (1.0 - u[i]);
			const double turn = 4e-16 / std::sin(phi[i]);
			EXPECT_LT(relative_error(image.xi, xi[i]), 1e-13 + 1e-15 / xi[i] + place) << i;
			EXPECT_LT(relative_error(image.magnification, mu[i]), 1e-12 + 4.0 * turn + 4.0 * place) << i;
			EXPECT_LT(relative_error(image.redshift, g[i]), 1e-14 + place) << i;
			const glm::dvec3 expected = -kOutward * std::cos(xi[i]) + kAcross * (side[i] * std::sin(xi[i]));
			EXPECT_LT(glm::length(image.direction - expected), 4e-15 + turn * std::sin(xi[i]) + place) << i;
		}
	}
}

TEST(StarImage, IsFoundAgainByTracingItsDirection) {
	for (const double r : {0.1, 0.5, 1.0, 1.2, 1.5, 3.0, 10.0, 100.0}) {
		for (const ObserverMotion motion : {ObserverMotion::kRain, ObserverMotion::kStatic}) {
			if (motion == ObserverMotion::kStatic && r <= 1.0) {
				continue;
			}
			for (const double phi : {0.1, 1.0, 2.0, 3.0}) {
				for (int order = 0; order < 4; ++order) {
					const StarImage image = image_of(r, phi, order, motion);
					const auto ray = trace_view_direction(kOutward * r, image.direction, motion);
					ASSERT_TRUE(ray);
					ASSERT_FALSE(ray.value->captured);
					// Directions are rounded to 1e-16; higher orders magnify that by e^Phi.
					const double tolerance =
							4e-15 * std::exp(std::max(image.orbital_angle - pi, 0.0)) + 1e-13;
					EXPECT_LT(glm::length(ray.value->sky_direction - star_at(phi)), tolerance * (r + 1.0 / r))
							<< r << " " << order;
					EXPECT_LT(relative_error(ray.value->redshift, image.redshift), 1e-12 * (r + 1.0 / r));
				}
			}
		}
	}
}

TEST(StarImage, MagnificationIsTheRatioOfSolidAngles) {
	for (const double r : {0.3, 2.0, 20.0}) {
		for (int order = 0; order < 3; ++order) {
			const double phi = 1.1;
			const double h = 1e-5;
			const StarImage at = image_of(r, phi, order, ObserverMotion::kRain);
			const double slope = (image_of(r, phi + h, order, ObserverMotion::kRain).xi -
										 image_of(r, phi - h, order, ObserverMotion::kRain).xi) /
					(2.0 * h);
			EXPECT_LT(relative_error(at.magnification, std::sin(at.xi) * std::abs(slope) / std::sin(phi)),
					1e-7);
		}
	}
}

TEST(StarImage, MagnificationTimesRedshiftSquaredIsFrameFree) {
	for (const double r : {1.01, 1.5, 7.0, 1e5}) {
		for (int order = 0; order < 4; ++order) {
			const StarImage rain = image_of(r, 2.2, order, ObserverMotion::kRain);
			const StarImage rest = image_of(r, 2.2, order, ObserverMotion::kStatic);
			const double expected = rain.magnification * rain.redshift * rain.redshift;
			EXPECT_LT(relative_error(rest.magnification * rest.redshift * rest.redshift, expected), 1e-12);
			// And both differ by the one boost.
			const auto celerity = observer_celerity(ObserverMotion::kStatic, kOutward * r);
			const double doppler = doppler_factor(rain.direction, *celerity.value);
			EXPECT_LT(relative_error(rest.redshift, rain.redshift * doppler), 1e-12);
			EXPECT_LT(glm::length(rest.direction - boost_direction(rain.direction, *celerity.value)), 1e-13);
		}
	}
}

TEST(StarImage, OddOrdersLieOnTheOtherSide) {
	for (int order = 0; order < 4; ++order) {
		const StarImage image = image_of(10.0, 2.0, order, ObserverMotion::kStatic);
		const double side = glm::dot(image.direction, kAcross);
		EXPECT_GT(order % 2 == 0 ? side : -side, 0.0) << order;
	}
}

TEST(StarImage, HandlesStarsOnTheAxis) {
	// Straight behind the observer: finite, towards the star.
	const StarImage behind = image_of(5.0, 0.0, 0, ObserverMotion::kRain);
	EXPECT_NEAR(behind.xi, pi, 1e-15);
	EXPECT_LT(glm::length(behind.direction - kOutward), 1e-14);
	EXPECT_LT(
			relative_error(behind.magnification, image_of(5.0, 1e-6, 0, ObserverMotion::kRain).magnification),
			1e-9);
	EXPECT_NEAR(behind.redshift, 1.0 / (1.0 + std::sqrt(0.2)), 1e-14);
	// Straight behind the hole: a ring, infinitely bright; the direction is one of its points.
	const auto ring = star_image(kOutward * 5.0, -kOutward, 0, ObserverMotion::kRain);
	ASSERT_TRUE(ring);
	EXPECT_NEAR(glm::length(ring.value->direction), 1.0, 1e-15);
	EXPECT_NEAR(glm::dot(ring.value->direction, -kOutward), std::cos(ring.value->xi), 1e-15);
	EXPECT_GT(ring.value->magnification, 1e12);
}

TEST(StarImage, FailsWithAReason) {
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const glm::dvec3 place = kOutward * 3.0;
	EXPECT_FALSE(star_image(kOutward * 0.9, kAcross, 0, ObserverMotion::kStatic));
	EXPECT_FALSE(star_image(place, glm::dvec3(0.0), 0, ObserverMotion::kRain));
	EXPECT_FALSE(star_image(place, glm::dvec3(nan, 0.0, 1.0), 0, ObserverMotion::kRain));
	EXPECT_FALSE(star_image(glm::dvec3(0.0), kAcross, 0, ObserverMotion::kRain));
	EXPECT_FALSE(star_image(place, kAcross, -1, ObserverMotion::kRain));
	EXPECT_FALSE(star_image(place, kAcross, kMaxImageOrder + 1, ObserverMotion::kRain));
	EXPECT_FALSE(trace_view_direction(place, glm::dvec3(0.0), ObserverMotion::kRain));
}

TEST(TraceViewDirection, KnowsTheShadow) {
	for (const double r : {0.2, 1.0, 4.0, 1e4}) {
		const double edge = shadow_half_angle(1.0 / r, ObserverMotion::kRain);
		for (const double factor : {0.0, 0.5, 1.0 - 1e-9, 1.0 + 1e-9}) {
			const double xi = edge * factor;
			const auto ray = trace_view_direction(
					kOutward * r, -kOutward * std::cos(xi) + kAcross * std::sin(xi), ObserverMotion::kRain);
			ASSERT_TRUE(ray);
			EXPECT_EQ(ray.value->captured, factor < 1.0) << r << " " << factor;
		}
	}
	const auto away = trace_view_direction(kOutward * 4.0, kOutward, ObserverMotion::kStatic);
	ASSERT_TRUE(away);
	EXPECT_LT(glm::length(away.value->sky_direction - kOutward), 1e-14);
}

} // namespace
} // namespace blackhole::test
