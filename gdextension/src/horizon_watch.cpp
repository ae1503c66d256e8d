// SPDX-License-Identifier: MIT
#include "src/horizon_watch.h"

#include <algorithm>

#include <glm/geometric.hpp>

HorizonWatch::Side &HorizonWatch::side_of(const WatchingEye &eye, double r) {
	const auto of_viewport = [&eye](const Side &side) { return side.viewport == eye.viewport; };
	auto found = std::find_if(sides.begin(), sides.end(), of_viewport);
	if (found == sides.end()) {
		found = sides.insert(sides.end(), Side{eye.viewport});
	}
	if (found->camera != eye.camera) {
		found->camera = eye.camera;
		found->inside = r < 1.0;
	}
	return *found;
}

bool HorizonWatch::look(const std::vector<WatchingEye> &eyes, const glm::dvec3 &hole, double radius) {
	passed.clear();
	for (Side &side : sides) {
		side.seen = false;
	}
	for (const WatchingEye &eye : eyes) {
		const double r = glm::length(eye.place - hole) / radius;
		Side &side = side_of(eye, r);
		side.seen = true;
		const bool crosses = side.inside ? r > 1.0 + kHalfShell : r < 1.0 - kHalfShell;
		if (crosses) {
			side.inside = !side.inside;
			passed.push_back({eye.camera, side.inside});
		}
	}
	std::erase_if(sides, [](const Side &side) { return !side.seen; });
	return !passed.empty();
}
