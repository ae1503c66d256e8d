// SPDX-License-Identifier: MIT
// The shader's own source, compiled as C++, against the exact solution.
#include "core/tables/shader_lensing.h"

#include "core/relativity/image_direction.h"
#include "core/relativity/shadow.h"
#include "core/relativity/star_image.h"
#include "core/relativity/view_angle.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace blackhole::test {
namespace {

const LensingTables &baked() {
	static const LensingTables tables = bake_lensing_tables();
	return tables;
}

struct Place {
	double r;
	ObserverMotion motion;
};
const Place kPlaces[] = {{0.1, ObserverMotion::kRain}, {0.5, ObserverMotion::kRain},
		{1.0, ObserverMotion::kRain}, {1.2, ObserverMotion::kStatic}, {1.5, ObserverMotion::kStatic},
		{1.6, ObserverMotion::kStatic}, {3.0, ObserverMotion::kStatic}, {10.0, ObserverMotion::kStatic},
		{10.0, ObserverMotion::kRain}, {100.0, ObserverMotion::kStatic}, {1e4, ObserverMotion::kStatic}};
const glm::vec3 kOutward = glm::normalize(glm::vec3(0.4F, 0.3F, -0.8F));
const glm::vec3 kAcross = glm::normalize(glm::cross(kOutward, glm::vec3(0.1F, 1.0F, 0.0F)));

/// Angle between two directions, well-conditioned when small.
double angle_between(const glm::dvec3 &a, const glm::dvec3 &b) {
	return 2.0 * std::atan2(glm::length(a - b), glm::length(a + b));
}

TEST(ShaderStarImage, AgreesWithTheExactImage) {
	const ShaderLensing shader(baked());
	for (const Place &place : kPlaces) {
		const glm::vec3 position = kOutward * static_cast<float>(place.r);
		for (const float phi : {0.01F, 0.3F, 1.0F, 2.0F, 3.0F, 3.13F}) {
			const glm::vec3 star = glm::normalize(kOutward * std::cos(phi) + kAcross * std::sin(phi));
			for (int order = 0; order < 4; ++order) {
				// The rounded inputs are the question; only what the shader does with them is its error.
				const auto exact = star_image(glm::dvec3(position), glm::dvec3(star), order, place.motion);
				ASSERT_TRUE(exact) << exact.error;
				const auto found = shader.star_image(position, star, order, place.motion, 0.0F);
				const std::string where = "r " + std::to_string(place.r) + " phi " + std::to_string(phi) +
						" order " + std::to_string(order);
				// Close to the axis the direction's part across it is rounded by 6e-8/sin phi; the boost of a
				// static observer near the horizon stretches that.
				const double rounding = 5e-7 / std::sin(phi);
				EXPECT_LT(angle_between(glm::dvec3(found.direction), exact.value->direction), 3e-6) << where;
				EXPECT_NEAR(found.magnification / exact.value->magnification, 1.0, 1e-3 + rounding) << where;
				EXPECT_NEAR(found.redshift / exact.value->redshift, 1.0, 3e-5) << where;
			}
		}
	}
}

TEST(ShaderStarImage, IsFiniteOnTheAxis) {
	const ShaderLensing shader(baked());
	for (const Place &place : kPlaces) {
		for (const glm::vec3 &star : {kOutward, -kOutward}) {
			for (int order = 0; order < 4; ++order) {
				const auto image = shader.star_image(
						kOutward * static_cast<float>(place.r), star, order, place.motion, 1e-8F);
				EXPECT_TRUE(std::isfinite(image.magnification)) << place.r << " " << order;
				EXPECT_TRUE(std::isfinite(image.redshift)) << place.r << " " << order;
				EXPECT_FALSE(std::isnan(image.direction.x + image.direction.y + image.direction.z))
						<< place.r;
			}
		}
	}
}

TEST(ShaderRay, IsTheStarImagesRay) {
	// ray_of_angle() repeats the middle of lens_star_image(); both must stay the same function.
	const ShaderLensing shader(baked());
	for (const double r : {0.1, 1.0, 5.0, 300.0}) {
		for (const float phi : {0.2F, 1.5F, 2.9F}) {
			for (int order = 0; order < 4; ++order) {
				const double whole = order % 2 == 0 ? order * std::numbers::pi + phi
													: (order + 1) * std::numbers::pi - phi;
				const auto ray = shader.ray_of_angle(1.0 / r, whole);
				const glm::vec3 star(0.0F, std::sin(phi), std::cos(phi));
				const auto image = shader.star_image(glm::vec3(0.0F, 0.0F, static_cast<float>(r)), star,
						order, ObserverMotion::kRain, 0.0F);
				const double xi = std::acos(std::clamp(-double{image.direction.z}, -1.0, 1.0));
				const double expected = 2.0 * std::atan(double{ray.sigma} / (1.0 + std::sqrt(1.0 / r)));
				EXPECT_NEAR(xi, expected, 1e-6 + 2e-7 / xi) << r << " " << phi << " " << order;
			}
		}
	}
}

TEST(ShaderStarImage, IsWhereItsRoughPlaceSays) {
	// Stars are left out of the picture by their rough place and brightness: these must keep their promise.
	const ShaderLensing shader(baked());
	int told = 0;
	for (const ObserverMotion motion : {ObserverMotion::kStatic, ObserverMotion::kRain}) {
		for (double u = 1e-9; u < 20.0; u *= 1.3) {
			if (motion == ObserverMotion::kStatic && u > 0.999) {
				continue;
			}
			for (int order = 0; order < 4; ++order) {
				for (float phi = 0.005F; phi < 3.14F; phi += 0.015F) {
					const glm::vec3 star = kOutward * std::cos(phi) + kAcross * std::sin(phi);
					const glm::vec3 place = kOutward * static_cast<float>(1.0 / u);
					const auto rough = ShaderLensing::rough_place(place, star, order, motion);
					const auto image = shader.star_image(place, star, order, motion, 0.0F);
					EXPECT_LT(angle_between(glm::dvec3(rough.direction), glm::dvec3(image.direction)),
							double{rough.error} + 1e-6)
							<< "u " << u << " order " << order << " phi " << phi;
					if (order > 0) {
						EXPECT_GE(rough.magnification_limit, image.magnification)
								<< "u " << u << " order " << order << " phi " << phi;
					}
					if (order > 0 && rough.error < 1.0F) {
						EXPECT_LE(rough.magnification_limit, 1.35F * image.magnification)
								<< "u " << u << " order " << order << " phi " << phi;
						EXPECT_LE(image.redshift, rough.redshift_limit) << "u " << u << " phi " << phi;
						EXPECT_LE(rough.redshift_limit, 1.2F * image.redshift) << "u " << u << " phi " << phi;
					}
					told += rough.error < 0.1F ? 1 : 0;
				}
			}
		}
	}
	EXPECT_GT(told, 100000);
}

ObserverField field(ObserverMotion motion, double energy, const glm::dvec3 &vector, bool relative_to_static) {
	ObserverField result(motion);
	result.energy = energy;
	result.axis = result.celerity = vector;
	result.relative_to_static = relative_to_static;
	return result;
}

const std::vector<ObserverField> &moving_observers() {
	static const std::vector<ObserverField> fields = {
			field(ObserverMotion::kInfall, 1.7, glm::dvec3(0.0), false),
			field(ObserverMotion::kOrbit, 1.0, glm::dvec3(0.3, 1.0, 0.2), false),
			field(ObserverMotion::kVelocity, 1.0, glm::dvec3(-0.4, 2.0, 0.7), false),
			field(ObserverMotion::kVelocity, 1.0, glm::dvec3(0.9, -0.3, 0.5), true)};
	return fields;
}

TEST(ShaderStarImage, AgreesForEveryMovingObserver) {
	const ShaderLensing shader(baked());
	for (const double r : {1.7, 3.0, 10.0, 1000.0}) {
		const glm::vec3 position = kOutward * static_cast<float>(r);
		for (const ObserverField &observer : moving_observers()) {
			for (const float phi : {0.3F, 1.0F, 2.0F, 3.0F}) {
				const glm::vec3 star = glm::normalize(kOutward * std::cos(phi) + kAcross * std::sin(phi));
				for (int order = 0; order < 3; ++order) {
					const auto exact = star_image(glm::dvec3(position), glm::dvec3(star), order, observer);
					ASSERT_TRUE(exact) << exact.error;
					const auto found = shader.star_image(position, star, order, observer, 0.0F);
					EXPECT_LT(angle_between(glm::dvec3(found.direction), exact.value->direction), 6e-6)
							<< "r " << r << " order " << order << " phi " << phi;
					EXPECT_NEAR(found.magnification / exact.value->magnification, 1.0, 2e-3);
					EXPECT_NEAR(found.redshift / exact.value->redshift, 1.0, 1e-4);
					const auto back = shader.trace(position, found.direction, observer);
					if (order == 0) {
						EXPECT_FALSE(back.captured);
						EXPECT_LT(angle_between(glm::dvec3(back.direction), glm::dvec3(star)), 3e-4);
						EXPECT_NEAR(back.redshift / exact.value->redshift, 1.0, 1e-3);
					}
				}
			}
		}
	}
}

// Bits of effects.gdshaderinc.
constexpr int kDeflection = 1;
constexpr int kAberration = 2;
constexpr int kGravitationalShift = 4;
constexpr int kDoppler = 8;
constexpr int kMagnification = 16;
constexpr int kAll = lensing_shader::kAllEffects;

TEST(ShaderEffects, EachSwitchedOffAloneLeavesTheOthers) {
	const ShaderLensing shader(baked());
	for (const double r : {1.7, 4.0, 30.0}) {
		const glm::dvec3 place = glm::dvec3(kOutward) * r;
		const auto position = glm::vec3(place);
		for (const ObserverField &observer : moving_observers()) {
			const glm::vec3 star = glm::normalize(kOutward * std::cos(2.0F) + kAcross * std::sin(2.0F));
			const auto all = *star_image(place, glm::dvec3(star), 0, observer).value;
			const auto rest = *star_image(place, glm::dvec3(star), 0, ObserverMotion::kStatic).value;
			const auto image = [&](int effects) {
				return shader.star_image(position, star, 0, observer, 0.0F, effects);
			};
			const auto off = [](const glm::vec3 &found, const glm::dvec3 &expected) {
				return angle_between(glm::dvec3(found), expected);
			};
			// Gravitational shift and Doppler effect: factors of g, and of nothing else.
			const auto no_gravity = image(kAll & ~kGravitationalShift);
			EXPECT_NEAR(no_gravity.redshift * rest.redshift / all.redshift, 1.0, 1e-4);
			EXPECT_LT(off(no_gravity.direction, all.direction), 6e-6);
			const auto no_doppler = image(kAll & ~kDoppler);
			EXPECT_NEAR(no_doppler.redshift / rest.redshift, 1.0, 1e-5);
			EXPECT_NEAR(no_doppler.magnification / all.magnification, 1.0, 2e-3);
			EXPECT_NEAR(image(kAll & ~kGravitationalShift & ~kDoppler).redshift, 1.0, 1e-6);
			// Aberration: the static observer's places and sizes, the moving one's colours.
			const auto no_aberration = image(kAll & ~kAberration);
			EXPECT_LT(off(no_aberration.direction, rest.direction), 6e-6);
			EXPECT_NEAR(no_aberration.magnification / rest.magnification, 1.0, 2e-3);
			EXPECT_NEAR(no_aberration.redshift / all.redshift, 1.0, 1e-4);
			// Magnification: brightness alone.
			const auto no_magnification = image(kAll & ~kMagnification);
			EXPECT_EQ(no_magnification.magnification, 1.0F);
			EXPECT_LT(off(no_magnification.direction, all.direction), 6e-6);
			// Deflection: special relativity between the static observer, who sees the flat sky, and this
			// one.
			const auto seen_from_rest = *field_celerity(ObserverMotion::kStatic, place).value;
			const auto from_rain = *field_celerity(observer, place).value;
			const glm::dvec3 in_rain = boost_direction(glm::dvec3(star), -seen_from_rest);
			const auto no_deflection = image(kAll & ~kDeflection);
			EXPECT_LT(off(no_deflection.direction, boost_direction(in_rain, from_rain)), 6e-6) << r;
			const double doppler =
					doppler_factor(in_rain, from_rain) / doppler_factor(in_rain, seen_from_rest);
			EXPECT_NEAR(no_deflection.redshift / (doppler * rest.redshift), 1.0, 1e-4);
			EXPECT_NEAR(no_deflection.magnification * doppler * doppler, 1.0, 1e-3);
			// Neither: the flat sky.
			EXPECT_EQ(image(kAll & ~kDeflection & ~kAberration).direction, star);
		}
	}
}

TEST(ShaderEffects, BackgroundAndStarsAgree) {
	const ShaderLensing shader(baked());
	for (const double r : {0.6, 1.7, 8.0}) {
		const auto position = kOutward * static_cast<float>(r);
		for (const ObserverField &observer : moving_observers()) {
			const glm::vec3 star = glm::normalize(kOutward * std::cos(1.2F) + kAcross * std::sin(1.2F));
			for (int effects = 0; effects <= kAll; ++effects) {
				const auto image = shader.star_image(position, star, 0, observer, 0.0F, effects);
				const auto ray = shader.trace(position, image.direction, observer, effects);
				EXPECT_FALSE(ray.captured);
				EXPECT_LT(angle_between(glm::dvec3(ray.direction), glm::dvec3(star)), 3e-5)
						<< "r " << r << " effects " << effects;
				EXPECT_NEAR(ray.redshift / image.redshift, 1.0, 1e-4) << "r " << r << " effects " << effects;
			}
		}
	}
}

TEST(ShaderTrace, AgreesWithTheExactRay) {
	const ShaderLensing shader(baked());
	for (const Place &place : kPlaces) {
		const glm::vec3 position = kOutward * static_cast<float>(place.r);
		const double edge = shadow_half_angle(1.0 / place.r, place.motion);
		for (const double part : {0.002, 0.02, 0.1, 0.3, 0.6, 0.9, 0.99}) {
			const auto xi = static_cast<float>(edge + part * (std::numbers::pi - edge));
			const glm::vec3 view = glm::normalize(kAcross * std::sin(xi) - kOutward * std::cos(xi));
			const auto exact = trace_view_direction(glm::dvec3(position), glm::dvec3(view), place.motion);
			ASSERT_TRUE(exact);
			const auto found = shader.trace(position, view, place.motion);
			ASSERT_EQ(found.captured, exact.value->captured);
			// The table's error, and the single-precision view direction magnified by |dPhi/dxi|.
			const double tolerance = 1e-5 + 1e-6 * std::abs(found.slope);
			EXPECT_LT(angle_between(glm::dvec3(found.direction), exact.value->sky_direction), tolerance)
					<< "r " << place.r << " xi " << xi;
			EXPECT_NEAR(found.redshift / exact.value->redshift, 1.0, 2e-5) << "r " << place.r << " xi " << xi;
		}
	}
}

TEST(ShaderTrace, HasTheShadowWhereItIs) {
	const ShaderLensing shader(baked());
	for (const Place &place : kPlaces) {
		const glm::vec3 position = kOutward * static_cast<float>(place.r);
		const double edge = shadow_half_angle(1.0 / place.r, place.motion);
		// A thousandth of a pixel at 60 degrees over 720 rows is 1.5e-6 rad.
		for (const double offset : {-2e-6, 2e-6}) {
			const auto xi = edge + offset;
			const glm::vec3 view(glm::dvec3(kAcross) * std::sin(xi) - glm::dvec3(kOutward) * std::cos(xi));
			EXPECT_EQ(shader.trace(position, view, place.motion).captured, offset < 0.0) << place.r;
		}
	}
}

TEST(ShaderRay, IsContinuousInTheObserversPlace) {
	// Across the rows of the table, the photon sphere, the horizon and the table's far end no step is
	// visible.
	const ShaderLensing shader(baked());
	for (const double phi : {0.5, 2.5, 3.3, 6.0}) {
		double before = 0.0;
		for (double log_u = std::log(1e-9); log_u < std::log(20.0); log_u += 0.003) {
			const double u = std::exp(log_u);
			const double ratio = shader.ray_of_angle(u, phi).clearance / image_direction(u, phi).y;
			EXPECT_NEAR(ratio, 1.0, 1e-3) << u << " " << phi;
			if (before != 0.0) {
				EXPECT_NEAR(ratio, before, 3e-5) << u << " " << phi;
			}
			before = ratio;
		}
	}
}

} // namespace
} // namespace blackhole::test
