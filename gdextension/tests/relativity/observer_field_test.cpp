// SPDX-License-Identifier: MIT
// Observers of every kind: what is the same for all of them, and where they do not exist.
#include "core/relativity/observer_field.h"

#include "core/relativity/shadow.h"
#include "core/relativity/star_image.h"
#include "relativity/reference_data.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace blackhole::test {
namespace {

ObserverField infall(double energy, bool outgoing = false) {
	ObserverField field(ObserverMotion::kInfall);
	field.energy = energy;
	field.outgoing = outgoing;
	return field;
}

ObserverField orbit(const glm::dvec3 &axis) {
	ObserverField field(ObserverMotion::kOrbit);
	field.axis = axis;
	return field;
}

ObserverField velocity(const glm::dvec3 &celerity, bool relative_to_static = false) {
	ObserverField field(ObserverMotion::kVelocity);
	field.celerity = celerity;
	field.relative_to_static = relative_to_static;
	return field;
}

const std::vector<ObserverField> kEverywhereOutside = {ObserverMotion::kStatic, ObserverMotion::kRain,
		infall(0.99), infall(3.0), infall(1.0, true), orbit(glm::dvec3(0.2, 1.0, -0.4)),
		velocity(glm::dvec3(3.0, -2.0, 0.5)), velocity(glm::dvec3(-0.3, 0.1, 0.7), true)};

class Directions {
public:
	glm::dvec3 next() {
		const double z = 2.0 * unit(random) - 1.0;
		const double angle = 2.0 * std::numbers::pi * unit(random);
		return glm::dvec3(
				std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle), z);
	}

private:
	std::mt19937_64 random{5};
	std::uniform_real_distribution<double> unit{0.0, 1.0};
};

TEST(ObserverField, EveryObserverAtAPlaceSeesTheSameMuGSquared) {
	Directions directions;
	for (const double r : {1.8, 3.0, 6.0, 40.0}) {
		for (int trial = 0; trial < 20; ++trial) {
			const glm::dvec3 place = directions.next() * r;
			const glm::dvec3 star = directions.next();
			for (int order = 0; order < 3; ++order) {
				double expected = 0.0;
				for (const ObserverField &field : kEverywhereOutside) {
					const auto image = star_image(place, star, order, field);
					ASSERT_TRUE(image) << image.error;
					const double invariant =
							image.value->magnification * image.value->redshift * image.value->redshift;
					if (expected == 0.0) {
						expected = invariant;
					}
					EXPECT_LT(relative_error(invariant, expected), 1e-10);
				}
			}
		}
	}
}

TEST(ObserverField, LookingAtAnImageFindsTheStar) {
	Directions directions;
	for (const double r : {1.7, 4.0, 40.0}) {
		for (const ObserverField &field : kEverywhereOutside) {
			const glm::dvec3 place = directions.next() * r;
			const glm::dvec3 star = directions.next();
			const auto image = star_image(place, star, 1, field);
			ASSERT_TRUE(image);
			const auto ray = trace_view_direction(place, image.value->direction, field);
			ASSERT_TRUE(ray) << ray.error;
			ASSERT_FALSE(ray.value->captured);
			EXPECT_LT(glm::length(ray.value->sky_direction - star), 1e-6);
			EXPECT_LT(relative_error(ray.value->redshift, image.value->redshift), 1e-8);
		}
	}
}

TEST(ObserverField, IsOneBoostFromRain) {
	// The celerity from rain gives what kappa gives.
	Directions directions;
	for (const ObserverField &field : kEverywhereOutside) {
		const glm::dvec3 place = directions.next() * 5.0;
		const glm::dvec3 star = directions.next();
		const auto celerity = field_celerity(field, place);
		ASSERT_TRUE(celerity);
		const auto rain = star_image(place, star, 0, ObserverMotion::kRain);
		const auto moved = star_image(place, star, 0, field);
		EXPECT_LT(
				glm::length(boost_direction(rain.value->direction, *celerity.value) - moved.value->direction),
				1e-13);
		const double doppler = doppler_factor(rain.value->direction, *celerity.value);
		EXPECT_LT(relative_error(rain.value->redshift * doppler, moved.value->redshift), 1e-13);
	}
}

TEST(ObserverField, RestAndZeroVelocityAreTheStaticObserver) {
	const glm::dvec3 place(1.0, 2.0, -2.0);
	const auto rest = field_celerity(ObserverMotion::kStatic, place);
	EXPECT_LT(
			glm::length(*field_celerity(velocity(glm::dvec3(0.0), true), place).value - *rest.value), 1e-15);
	EXPECT_LT(glm::length(*field_celerity(infall(energy_from_rest(3.0)), place).value - *rest.value), 1e-7);
	EXPECT_EQ(*field_celerity(velocity(glm::dvec3(0.0)), place).value, glm::dvec3(0.0));
}

TEST(ObserverField, ComposedCelerityAddsVelocities) {
	const auto along = [](double beta) { return glm::dvec3(beta / std::sqrt(1.0 - beta * beta), 0.0, 0.0); };
	const double beta = (0.6 + 0.7) / (1.0 + 0.6 * 0.7);
	EXPECT_LT(glm::length(composed_celerity(along(0.6), along(0.7)) - along(beta)), 1e-14);
	const glm::dvec3 there(1.0, -0.4, 2.0);
	EXPECT_LT(glm::length(composed_celerity(there, glm::dvec3(0.0)) - there), 1e-15);
}

TEST(ObserverField, ShadowIsTheCircleWhereRaysAreCaptured) {
	Directions directions;
	for (const double r : {1.7, 2.5, 4.0, 30.0}) {
		for (const ObserverField &field : kEverywhereOutside) {
			const glm::dvec3 place = directions.next() * r;
			const auto shadow = apparent_shadow(place, field);
			ASSERT_TRUE(shadow) << shadow.error;
			const glm::dvec3 centre = shadow.value->centre;
			const glm::dvec3 side = glm::normalize(glm::cross(centre, directions.next()));
			const glm::dvec3 other = glm::cross(centre, side);
			for (int step = 0; step < 12; ++step) {
				const double turn = step * std::numbers::pi / 6.0;
				const glm::dvec3 across = side * std::cos(turn) + other * std::sin(turn);
				for (const double offset : {-1e-5, 1e-5}) {
					const double angle = shadow.value->half_angle + offset;
					const auto ray = trace_view_direction(
							place, centre * std::cos(angle) + across * std::sin(angle), field);
					ASSERT_TRUE(ray);
					EXPECT_EQ(ray.value->captured, offset < 0.0) << "r " << r << " step " << step;
				}
			}
		}
	}
}

TEST(ObserverField, ShadowOfAFlightStraightAtTheHoleStaysInPlace) {
	const glm::dvec3 place(0.0, 3.0, 4.0);
	for (const double speed : {-30.0, -5.0, 0.3, 7.0}) {
		const auto shadow = apparent_shadow(place, velocity(place * (speed / 5.0)));
		ASSERT_TRUE(shadow);
		EXPECT_LT(glm::length(shadow.value->centre + place / 5.0), 1e-12);
		const double doppler = std::hypot(1.0, speed) - speed; // of light from the hole's direction
		const double half = std::tan(0.5 * shadow_half_angle(0.2, ObserverMotion::kRain)) / doppler;
		EXPECT_NEAR(shadow.value->half_angle, 2.0 * std::atan(half), 1e-12);
	}
}

TEST(ObserverField, RefusesWhatDoesNotExist) {
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const auto refused = [](const ObserverField &field, double r) {
		const auto at = local_observer(field, glm::dvec3(0.0, 0.0, r));
		EXPECT_FALSE(at) << r;
		return at.error;
	};
	EXPECT_NE(refused(ObserverMotion::kStatic, 1.0).find("horizon"), std::string::npos);
	EXPECT_NE(refused(infall(0.5), 2.0).find("energy"), std::string::npos);
	EXPECT_NE(refused(infall(-1.0), 2.0).find("energy"), std::string::npos);
	EXPECT_NE(refused(infall(nan), 2.0).find("energy"), std::string::npos);
	EXPECT_NE(refused(infall(2.0, true), 0.9).find("outward"), std::string::npos);
	EXPECT_NE(refused(orbit(glm::dvec3(0.0, 1.0, 0.0)), 1.5).find("1.5"), std::string::npos);
	EXPECT_NE(refused(orbit(glm::dvec3(0.0, 0.0, 1.0)), 4.0).find("axis"), std::string::npos);
	EXPECT_NE(refused(orbit(glm::dvec3(nan, 0.0, 1.0)), 4.0).find("axis"), std::string::npos);
	EXPECT_NE(refused(velocity(glm::dvec3(nan, 0.0, 0.0)), 4.0).find("velocity"), std::string::npos);
	EXPECT_NE(refused(velocity(glm::dvec3(0.1, 0.0, 0.0), true), 0.5).find("static"), std::string::npos);
	EXPECT_NE(refused(ObserverMotion::kRain, 0.0).find("position"), std::string::npos);
	// What exists inside the horizon.
	EXPECT_TRUE(local_observer(infall(0.5), glm::dvec3(0.0, 0.0, 0.8)));
	EXPECT_TRUE(local_observer(velocity(glm::dvec3(3.0, 0.0, 0.0)), glm::dvec3(0.0, 0.0, 0.1)));
}

} // namespace
} // namespace blackhole::test
