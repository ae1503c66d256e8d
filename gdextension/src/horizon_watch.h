// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "src/eye_tracker.h"

/// Notices when the camera of a viewport passes the horizon. One that trembles at it passes once: it has to
/// come out of a thin shell about r = 1 on the other side.
class HorizonWatch {
public:
	struct Crossing {
		uint64_t camera = 0; ///< instance
		bool inward = false;
	};

	/// Half the shell's thickness, r_s.
	static constexpr double kHalfShell = 1e-3;

	/// Compares with the last look; places in world units, `radius` is the horizon's. Returns whether a
	/// camera has passed. A camera that is new in its viewport has not.
	bool look(const std::vector<WatchingEye> &eyes, const glm::dvec3 &hole, double radius);
	/// Those of the last look. Both vectors keep their memory: nothing is allocated from frame to frame.
	const std::vector<Crossing> &crossings() const { return passed; }
	/// There is no horizon now; whoever looks next is new.
	void forget() { sides.clear(); }

private:
	struct Side {
		uint64_t viewport = 0;
		uint64_t camera = 0;
		bool inside = false;
		bool seen = false; ///< in this look
	};
	Side &side_of(const WatchingEye &eye, double r);

	std::vector<Side> sides;
	std::vector<Crossing> passed;
};
