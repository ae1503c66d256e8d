// SPDX-License-Identifier: MIT
#include "core/relativity/star_image.h"

#include "core/relativity/critical.h"
#include "core/relativity/image_direction.h"
#include "core/relativity/magnification.h"
#include "core/relativity/redshift.h"
#include "core/relativity/sky_frame.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace blackhole {

Outcome<StarImage> star_image(
		glm::dvec3 position_rs, glm::dvec3 star_direction, int order, const ObserverField &observer) {
	if (order < 0 || order > kMaxImageOrder) {
		return Outcome<StarImage>::failure("the image order must be between 0 and 60");
	}
	const Outcome<LocalObserver> local = local_observer(observer, position_rs);
	if (!local) {
		return Outcome<StarImage>::failure(local.error);
	}
	const Outcome<SkyFrame> frame = sky_frame(*local.value, star_direction);
	if (!frame) {
		return Outcome<StarImage>::failure(frame.error);
	}
	const SkyFrame &at = *frame.value;
	const bool opposite = order % 2 == 1;
	// The star's angle from the outward radial, or its complement for odd orders: Phi = order pi + that.
	double rest = opposite ? 2.0 * std::atan2(at.far, at.near) : 2.0 * std::atan2(at.near, at.far);
	double sine = 0.5 * at.near * at.far;
	if (order == 0 && rest < 1e-100) {
		rest = sine = 1e-100; // the limit of a star straight away from the hole, to every digit
	}
	StarImage image;
	image.orbital_angle = order * std::numbers::pi + rest;
	const ImageDirection ray = image_direction(at.u, image.orbital_angle);
	const double sigma = critical_sigma(at.u) + ray.y;
	const double half = std::atan2(sigma, at.kappa);
	image.xi = 2.0 * half;
	const double side = opposite ? -1.0 : 1.0;
	image.direction = at.azimuth * (side * std::sin(image.xi)) - at.outward * std::cos(image.xi);
	image.magnification = radial_magnification(at.u, ray, at.kappa, sine);
	image.redshift = radial_redshift(at.u, ray.y, at.kappa);
	if (at.celerity != glm::dvec3(0.0)) {
		const double doppler = doppler_factor(image.direction, at.celerity);
		image.direction = boost_direction(image.direction, at.celerity);
		image.magnification /= doppler * doppler;
		image.redshift *= doppler;
	}
	return Outcome<StarImage>::success(image);
}

} // namespace blackhole
