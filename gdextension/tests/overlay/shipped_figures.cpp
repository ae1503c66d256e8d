// SPDX-License-Identifier: MIT
#include "tests/overlay/shipped_figures.h"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <numbers>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace blackhole {
namespace {

glm::dvec3 sky_direction(const nlohmann::json &place) {
	const double ra = place.at(0).get<double>() * std::numbers::pi / 180.0;
	const double dec = place.at(1).get<double>() * std::numbers::pi / 180.0;
	return {std::cos(dec) * std::cos(ra), std::sin(dec), -std::cos(dec) * std::sin(ra)};
}

} // namespace

std::vector<SkySegment> shipped_figures() {
	std::ifstream file(BLACKHOLE_PROJECT_ROOT "/addons/blackhole_sky/data/constellations.json");
	const nlohmann::json data = nlohmann::json::parse(file);
	std::vector<SkySegment> segments;
	for (const nlohmann::json &constellation : data.at("constellations")) {
		for (const nlohmann::json &line : constellation.at("lines")) {
			for (std::size_t i = 1; i < line.size(); ++i) {
				segments.push_back({sky_direction(line[i - 1]), sky_direction(line[i])});
			}
		}
	}
	return segments;
}

} // namespace blackhole
