// SPDX-License-Identifier: MIT
#include "core/relativity/clocks.h"

#include "core/relativity/observer.h"
#include "core/relativity/shadow.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace blackhole {
namespace {

constexpr const char *kNoCelerity = "the observer's celerity must be finite";

} // namespace

Outcome<double> far_clock_rate(glm::dvec3 position_rs, glm::dvec3 celerity, glm::dvec3 view_direction) {
	const double length = glm::length(view_direction);
	if (!(length > 0.0 && std::isfinite(length))) {
		return Outcome<double>::failure("the viewing direction must be finite and have a length");
	}
	if (!std::isfinite(glm::length(celerity))) {
		return Outcome<double>::failure(kNoCelerity);
	}
	const glm::dvec3 rain_direction = boost_direction(view_direction / length, -celerity);
	const Outcome<SkyRay> ray = trace_view_direction(position_rs, rain_direction, ObserverMotion::kRain);
	if (!ray) {
		return Outcome<double>::failure(ray.error);
	}
	if (ray.value->captured) {
		return Outcome<double>::failure("no far clock is seen in the directions of the hole's shadow");
	}
	return Outcome<double>::success(ray.value->redshift * doppler_factor(rain_direction, celerity));
}

Outcome<double> far_clock_rate_outward(glm::dvec3 position_rs, glm::dvec3 celerity) {
	const double r = glm::length(position_rs);
	if (!(r > 0.0 && std::isfinite(r))) {
		return Outcome<double>::failure("the observer's position must be finite and away from the centre");
	}
	if (!std::isfinite(glm::length(celerity))) {
		return Outcome<double>::failure(kNoCelerity);
	}
	// rain's 1/(1 + sqrt(u)), then the Doppler factor
	const double root = std::sqrt(r);
	return Outcome<double>::success(root / (root + 1.0) * doppler_factor(position_rs / r, celerity));
}

} // namespace blackhole
