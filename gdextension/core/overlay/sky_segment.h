// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace blackhole {

/// The shorter arc of a great circle between two unit vectors that are not opposite.
struct SkySegment {
	glm::dvec3 from{1.0, 0.0, 0.0};
	glm::dvec3 to{1.0, 0.0, 0.0};
};

/// A segment made ready for many questions.
class SegmentDistance {
public:
	explicit SegmentDistance(const SkySegment &segment);

	/// Cosine of the angle from the unit vector `direction` to the nearest point of the segment.
	[[nodiscard]] double cosine(const glm::dvec3 &direction) const;

	/// The point of the segment nearest to the unit vector `direction`, a unit vector.
	[[nodiscard]] glm::dvec3 nearest_point(const glm::dvec3 &direction) const;

private:
	/// Whether the nearest point of the whole great circle is on the segment.
	[[nodiscard]] bool beside(const glm::dvec3 &direction) const;

	SkySegment _segment;
	/// Pole of the great circle; zero for a segment without length.
	glm::dvec3 _pole{0.0};
	/// Unit tangents at the two ends, towards the inside; zero for a segment without length.
	glm::dvec3 _inward_from{0.0};
	glm::dvec3 _inward_to{0.0};
};

} // namespace blackhole
