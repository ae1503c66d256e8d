// SPDX-License-Identifier: MIT
#include "core/photometry/sky_brightness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/photometry/radiometry.h"

namespace blackhole {

namespace {

/// Solid angle seen from the centre of the rectangle between the axes and (s, t) on a face.
double corner(double p_s, double p_t) {
	return std::atan(p_s * p_t / std::sqrt(1.0 + p_s * p_s + p_t * p_t));
}

/// Where cell borders lie on a face, -1 to 1.
double border(int p_number) {
	return 2.0 * p_number / SkyBrightness::kSize - 1.0;
}

double cell_solid_angle(int p_column, int p_row) {
	const double s0 = border(p_column);
	const double s1 = border(p_column + 1);
	const double t0 = border(p_row);
	const double t1 = border(p_row + 1);
	return corner(s1, t1) - corner(s0, t1) - corner(s1, t0) + corner(s0, t0);
}

int place_on_face(double p_coordinate) {
	const int place = static_cast<int>(0.5 * (p_coordinate + 1.0) * SkyBrightness::kSize);
	return std::clamp(place, 0, SkyBrightness::kSize - 1);
}

} // namespace

double colour_temperature(double p_red, double p_blue) {
	const double ratio = std::log(std::max(p_blue, 1e-9) / std::max(p_red, 1e-9));
	const double x = std::clamp(ratio, -4.8150, 1.0182);
	const double inverse = 1.541962 + x * (-1.049664 + x * (-0.090338 + x * (-0.028169 - 0.005150 * x)));
	return std::clamp(1e4 / inverse, 2000.0, 30000.0);
}

std::size_t SkyBrightness::cell(const glm::dvec3 &p_direction) {
	// The inverse of cube_point().
	const glm::dvec3 &d = p_direction;
	const glm::dvec3 size = glm::dvec3(std::abs(d.x), std::abs(d.y), std::abs(d.z));
	int face = 0;
	glm::dvec3 place(0.0); // s, t, depth
	if (size.x >= size.y && size.x >= size.z) {
		face = d.x > 0.0 ? 0 : 1;
		place = {d.x > 0.0 ? -d.z : d.z, -d.y, size.x};
	} else if (size.y >= size.z) {
		face = d.y > 0.0 ? 2 : 3;
		place = {d.x, d.y > 0.0 ? d.z : -d.z, size.y};
	} else {
		face = d.z > 0.0 ? 4 : 5;
		place = {d.z > 0.0 ? d.x : -d.x, -d.y, size.z};
	}
	const int column = place_on_face(place.x / place.z);
	const int row = place_on_face(place.y / place.z);
	return static_cast<std::size_t>(face * kSize + row) * kSize + static_cast<std::size_t>(column);
}

SkyBrightness SkyBrightness::means(const Sums &p_sums) {
	SkyBrightness sky;
	for (std::size_t i = 0; i < kCells; ++i) {
		if (p_sums.light[i] > 0.0 && p_sums.solid_angle[i] > 0.0) {
			sky.m_cells[i].luminance = static_cast<float>(p_sums.light[i] / p_sums.solid_angle[i]);
			sky.m_cells[i].temperature = static_cast<float>(p_sums.heat[i] / p_sums.light[i]);
		}
	}
	return sky;
}

SkyBrightness SkyBrightness::of_stars(const StarTable &p_table, double p_faintest) {
	Sums sums;
	for (std::size_t i = 0; i < kCells; ++i) {
		const int place = static_cast<int>(i % (std::size_t{kSize} * kSize));
		sums.solid_angle[i] = cell_solid_angle(place % kSize, place / kSize);
	}
	const std::size_t count = p_table.count_to(p_faintest);
	for (std::size_t i = 0; i < count; ++i) {
		const Star &star = p_table.stars[i];
		const std::size_t at = cell(world_direction(star));
		// The luminance over one steradian.
		const double light = star_luminance_sum(star.v_magnitude, 1.0);
		sums.light[at] += light;
		sums.heat[at] += light * star.temperature_k;
	}
	return means(sums);
}

SkyBrightness SkyBrightness::of_panorama(const float *p_rgb, int p_columns, int p_rows) {
	Sums sums;
	for (int row = 0; row < p_rows; ++row) {
		const double declination = std::numbers::pi * (0.5 - (row + 0.5) / p_rows);
		for (int column = 0; column < p_columns; ++column, p_rgb += 3) {
			const double right_ascension = 2.0 * std::numbers::pi * (0.25 - (column + 0.5) / p_columns);
			const std::size_t at = cell(world_direction(right_ascension, declination));
			const double luminance = 0.2126 * p_rgb[0] + 0.7152 * p_rgb[1] + 0.0722 * p_rgb[2];
			const double solid_angle = std::cos(declination); // in proportion
			sums.solid_angle[at] += solid_angle;
			if (luminance > 0.0 && std::isfinite(luminance)) {
				sums.light[at] += luminance * solid_angle;
				sums.heat[at] += luminance * solid_angle * colour_temperature(p_rgb[0], p_rgb[2]);
			}
		}
	}
	return means(sums);
}

} // namespace blackhole
