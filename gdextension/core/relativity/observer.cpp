// SPDX-License-Identifier: MIT
#include "core/relativity/observer.h"

#include "core/relativity/not_a_number.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace blackhole {
namespace {

constexpr const char *kNoPlace = "the observer's position must be finite and away from the centre";

/// A direction against a motion, in forms that keep their digits at high speed.
struct Split {
	double size;
	double gamma;
	glm::dvec3 axis;
	double cosine;
	/// 1 + cosine, as half the square of |axis + direction|.
	double one_plus_cosine;

	Split(const glm::dvec3 &direction, const glm::dvec3 &celerity)
			: size(glm::length(celerity)), gamma(std::hypot(1.0, size)),
			  axis(size > 0.0 ? celerity / size : glm::dvec3(0.0)), cosine(glm::dot(axis, direction)),
			  one_plus_cosine(0.5 * glm::dot(axis + direction, axis + direction)) {}

	/// gamma + gamma beta cos; gamma - gamma beta = 1/(gamma + gamma beta).
	[[nodiscard]] double doppler() const {
		return cosine >= 0.0 ? gamma + size * cosine : 1.0 / (gamma + size) + size * one_plus_cosine;
	}
};

} // namespace

double radial_kappa(double u, ObserverMotion motion) {
	if (!(u > 0.0)) {
		return kNaN;
	}
	if (motion == ObserverMotion::kRain) {
		return 1.0 + std::sqrt(u);
	}
	return motion == ObserverMotion::kStatic && u < 1.0 ? std::sqrt(1.0 - u) : kNaN;
}

double infall_kappa(double u, double energy) {
	double kinetic = energy * energy - 1.0 + u;
	if (std::abs(kinetic) < 4e-16) {
		kinetic = 0.0; // at rest, within rounding
	}
	return energy > 0.0 && u > 0.0 && kinetic >= 0.0 ? energy + std::sqrt(kinetic) : kNaN;
}

double outgoing_kappa(double u, double energy) {
	return u < 1.0 ? (1.0 - u) / infall_kappa(u, energy) : kNaN;
}

Outcome<glm::dvec3> observer_celerity(ObserverMotion motion, glm::dvec3 position_rs) {
	const double r = glm::length(position_rs);
	if (!(r > 0.0 && std::isfinite(r))) {
		return Outcome<glm::dvec3>::failure(
				"the observer's position must be finite and away from the centre");
	}
	if (motion == ObserverMotion::kRain) {
		return Outcome<glm::dvec3>::success(glm::dvec3(0.0));
	}
	if (motion != ObserverMotion::kStatic) {
		return Outcome<glm::dvec3>::failure("this motion needs more to be known: see ObserverField");
	}
	if (r <= 1.0) {
		return Outcome<glm::dvec3>::failure(
				"no observer can be static at or inside the horizon; choose rain or go "
				"beyond r = 1 r_s");
	}
	// gamma beta = sqrt(u)/sqrt(1 - u) outward, u = 1/r
	return Outcome<glm::dvec3>::success(position_rs * (1.0 / (r * std::sqrt(r - 1.0))));
}

Outcome<glm::dvec3> radial_celerity(glm::dvec3 position_rs, double kappa) {
	const double r = glm::length(position_rs);
	if (!(r > 0.0 && std::isfinite(r))) {
		return Outcome<glm::dvec3>::failure(kNoPlace);
	}
	if (!(kappa > 0.0 && std::isfinite(kappa))) {
		return Outcome<glm::dvec3>::failure("no observer moves radially in this way here");
	}
	const double ratio = radial_kappa(1.0 / r, ObserverMotion::kRain) / kappa;
	return Outcome<glm::dvec3>::success(position_rs * (0.5 * (ratio - 1.0 / ratio) / r));
}

Outcome<glm::dvec3> orbit_celerity(glm::dvec3 position_rs, glm::dvec3 axis) {
	const double r = glm::length(position_rs);
	const glm::dvec3 along = glm::cross(axis, position_rs);
	const double along_length = glm::length(along);
	if (!(r > 1.5 && std::isfinite(r))) {
		return Outcome<glm::dvec3>::failure("circular orbits exist beyond r = 1.5 r_s only");
	}
	if (!(along_length > 0.0 && std::isfinite(along_length))) {
		return Outcome<glm::dvec3>::failure("the orbit's axis must not point along the observer's position");
	}
	// u/(2 - 3u) = 1/(2 r - 3)
	const double tangential = 1.0 / std::sqrt(2.0 * r - 3.0);
	return Outcome<glm::dvec3>::success(
			position_rs * (std::sqrt(2.0) * tangential / r) + along * (tangential / along_length));
}

glm::dvec3 composed_celerity(glm::dvec3 frame, glm::dvec3 relative) {
	const double frame_gamma = std::sqrt(1.0 + glm::dot(frame, frame));
	const double gamma = std::sqrt(1.0 + glm::dot(relative, relative));
	return relative + frame * (gamma + glm::dot(frame, relative) / (1.0 + frame_gamma));
}

glm::dvec3 boost_direction(glm::dvec3 toward_source, glm::dvec3 celerity) {
	const Split split(toward_source, celerity);
	if (split.size == 0.0) {
		return glm::normalize(toward_source);
	}
	// Across the motion n' = n/D, along it (gamma cos + gamma beta)/D.
	const double along = split.cosine >= 0.0
			? split.gamma * split.cosine + split.size
			: split.gamma * split.one_plus_cosine - 1.0 / (split.gamma + split.size);
	return glm::normalize((toward_source - split.axis * split.cosine + split.axis * along) / split.doppler());
}

double doppler_factor(glm::dvec3 toward_source, glm::dvec3 celerity) {
	return Split(toward_source, celerity).doppler();
}

} // namespace blackhole
