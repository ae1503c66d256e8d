// SPDX-License-Identifier: MIT
#include "core/relativity/sky_frame.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace blackhole {

Outcome<SkyFrame> sky_frame(const LocalObserver &at, glm::dvec3 direction) {
	const double length = glm::length(direction);
	if (!(length > 0.0 && std::isfinite(length))) {
		return Outcome<SkyFrame>::failure("a direction must be finite and not zero");
	}
	const glm::dvec3 n = direction / length;
	SkyFrame frame;
	frame.u = at.u;
	frame.kappa = at.kappa;
	frame.celerity = at.celerity;
	frame.outward = at.outward;
	frame.near = glm::length(frame.outward - n);
	frame.far = glm::length(frame.outward + n);
	// Twice across the axis: the second pass removes what rounding left of the radial part.
	glm::dvec3 across = n - frame.outward * glm::dot(n, frame.outward);
	across -= frame.outward * glm::dot(across, frame.outward);
	if (glm::length(across) < 1e-15) {
		const glm::dvec3 helper =
				std::abs(frame.outward.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
		across = glm::cross(frame.outward, helper);
	}
	frame.azimuth = glm::normalize(across);
	return Outcome<SkyFrame>::success(frame);
}

Outcome<ViewFrame> view_frame(
		glm::dvec3 position_rs, glm::dvec3 view_direction, const ObserverField &observer) {
	const Outcome<LocalObserver> local = local_observer(observer, position_rs);
	if (!local) {
		return Outcome<ViewFrame>::failure(local.error);
	}
	// The boost undone.
	const glm::dvec3 celerity = local.value->celerity;
	const bool boosted = celerity != glm::dvec3(0.0);
	const glm::dvec3 direction =
			boosted ? boost_direction(glm::normalize(view_direction), -celerity) : view_direction;
	const Outcome<SkyFrame> frame = sky_frame(*local.value, direction);
	if (!frame) {
		return Outcome<ViewFrame>::failure(frame.error);
	}
	return Outcome<ViewFrame>::success({*frame.value, boosted ? doppler_factor(direction, celerity) : 1.0});
}

} // namespace blackhole
