// SPDX-License-Identifier: MIT
#include "core/overlay/sky_segment.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace blackhole {
namespace {

/// Shorter arcs count as points, radians: their direction would be rounding alone.
constexpr double kPoint = 1e-9;

} // namespace

SegmentDistance::SegmentDistance(const SkySegment &segment) : _segment(segment) {
	const glm::dvec3 normal = glm::cross(segment.from, segment.to);
	if (const double sine = glm::length(normal); sine > kPoint) {
		_pole = normal / sine;
		_inward_from = glm::cross(_pole, segment.from);
		_inward_to = glm::cross(segment.to, _pole);
	}
}

bool SegmentDistance::beside(const glm::dvec3 &direction) const {
	return glm::dot(_inward_from, direction) > 0.0 && glm::dot(_inward_to, direction) > 0.0;
}

double SegmentDistance::cosine(const glm::dvec3 &direction) const {
	if (beside(direction)) {
		const double sine = glm::dot(_pole, direction);
		return std::sqrt(std::max(0.0, 1.0 - sine * sine));
	}
	return std::max(glm::dot(_segment.from, direction), glm::dot(_segment.to, direction));
}

glm::dvec3 SegmentDistance::nearest_point(const glm::dvec3 &direction) const {
	if (beside(direction)) {
		return glm::normalize(direction - glm::dot(_pole, direction) * _pole);
	}
	const bool from_is_nearer = glm::dot(_segment.from, direction) >= glm::dot(_segment.to, direction);
	return from_is_nearer ? _segment.from : _segment.to;
}

} // namespace blackhole
