// SPDX-License-Identifier: MIT
#include "core/relativity/observer_field.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace blackhole {
namespace {

using Result = Outcome<LocalObserver>;

bool is_finite(const glm::dvec3 &v) {
	return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Result at_rest(LocalObserver at) {
	if (at.u >= 1.0) {
		return Result::failure(
				"no observer can be static at or inside the horizon; choose rain or go beyond r = 1 r_s");
	}
	at.kappa = radial_kappa(at.u, ObserverMotion::kStatic);
	if (!(at.kappa > 0.0)) {
		return Result::failure("the observer is too close to the horizon to be static in double "
							   "precision; choose rain");
	}
	return Result::success(at);
}

Result falling(const ObserverField &field, LocalObserver at) {
	if (!(field.energy > 0.0 && std::isfinite(field.energy))) {
		return Result::failure("the energy of a fall must be a positive number");
	}
	if (field.outgoing && at.u >= 1.0) {
		return Result::failure("nothing moves outward at or inside the horizon; choose the way in");
	}
	at.kappa = field.outgoing ? outgoing_kappa(at.u, field.energy) : infall_kappa(at.u, field.energy);
	if (!(at.kappa > 0.0)) {
		return Result::failure("the energy is too small to be here: a fall that passes r needs at least "
							   "sqrt(1 - 1/r)");
	}
	return Result::success(at);
}

Result moving(const ObserverField &field, LocalObserver at) {
	if (!is_finite(field.celerity)) {
		return Result::failure("the observer's velocity must be finite and below that of light");
	}
	at.celerity = field.celerity;
	if (field.relative_to_static) {
		if (at.u >= 1.0) {
			return Result::failure(
					"no observer is static at or inside the horizon, so no velocity is relative "
					"to one; give it relative to rain");
		}
		const glm::dvec3 resting = at.outward * std::sqrt(at.u / (1.0 - at.u));
		at.celerity = composed_celerity(resting, field.celerity);
	}
	return Result::success(at);
}

} // namespace

double energy_from_rest(double r) {
	return std::sqrt(1.0 - 1.0 / r);
}

Result local_observer(const ObserverField &field, glm::dvec3 position_rs) {
	const double r = glm::length(position_rs);
	if (!(r > 0.0 && std::isfinite(r))) {
		return Result::failure("the observer's position must be finite and away from the centre");
	}
	LocalObserver at;
	at.u = 1.0 / r;
	at.outward = position_rs / r;
	at.kappa = radial_kappa(at.u, ObserverMotion::kRain);
	switch (field.motion) {
		case ObserverMotion::kStatic:
			return at_rest(at);
		case ObserverMotion::kRain:
			return Result::success(at);
		case ObserverMotion::kInfall:
			return falling(field, at);
		case ObserverMotion::kOrbit: {
			const Outcome<glm::dvec3> celerity = orbit_celerity(position_rs, field.axis);
			if (!celerity) {
				return Result::failure(celerity.error);
			}
			at.celerity = *celerity.value;
			return Result::success(at);
		}
		case ObserverMotion::kVelocity:
			return moving(field, at);
	}
	return Result::failure("there is no such motion");
}

Outcome<glm::dvec3> field_celerity(const ObserverField &field, glm::dvec3 position_rs) {
	const Result at = local_observer(field, position_rs);
	if (!at) {
		return Outcome<glm::dvec3>::failure(at.error);
	}
	const bool radial = field.motion == ObserverMotion::kStatic || field.motion == ObserverMotion::kInfall;
	return radial ? radial_celerity(position_rs, at.value->kappa)
				  : Outcome<glm::dvec3>::success(at.value->celerity);
}

} // namespace blackhole
