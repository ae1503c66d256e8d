// SPDX-License-Identifier: MIT
#include "core/photometry/point_spread_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/photometry/pixel_blur.h"

namespace blackhole {

namespace {

using std::numbers::pi;
using Table = PointSpreadTable;
using Profile = std::vector<double>; // rows of columns

double radius_at(double p_column) {
	const double q = p_column / static_cast<double>(Table::kColumns - 1);
	return Table::kReach * q * (Table::kNearPart + (1.0 - Table::kNearPart) * q);
}

double ratio_of(std::size_t p_row) {
	return static_cast<double>(p_row) / static_cast<double>(Table::kRows - 1);
}

double gaussian(double p_t, double p_variance) {
	return std::exp(-p_t * p_t / (2.0 * p_variance)) / (2.0 * pi * p_variance);
}

template <class Function>
Profile rows_of(Function p_profile) {
	Profile nodes(Table::kRows * Table::kColumns);
	for (std::size_t j = 0; j < Table::kRows; ++j) {
		for (std::size_t i = 0; i < Table::kColumns; ++i) {
			nodes[j * Table::kColumns + i] = p_profile(radius_at(static_cast<double>(i)), ratio_of(j));
		}
	}
	return nodes;
}

/// A pattern, by profile and encircled light over x, blurred by the pixel.
Profile blurred_pattern(double (*p_profile)(double), double (*p_encircled)(double)) {
	return rows_of([p_profile, p_encircled](double t, double v) {
		if (v == 0.0) {
			return gaussian(t, 1.0);
		}
		if (v == 1.0) {
			return p_profile(t);
		}
		return pixel_blurred(
				[p_encircled, v](double r) { return p_encircled(r / v); }, std::sqrt(1.0 - v * v), t);
	});
}

Profile eye_profile(double p_glare) {
	static const Profile wings = blurred_pattern(eye_wings_profile, eye_wings_encircled);
	Profile sum =
			rows_of([](double t, double v) { return gaussian(t, 1.0 - v * v + kEyeCoreVariance * v * v); });
	for (std::size_t i = 0; i < sum.size(); ++i) {
		sum[i] = std::lerp(sum[i], wings[i], p_glare);
	}
	return sum;
}

Profile profile_of(PointSpread p_model, double p_glare) {
	switch (p_model) {
		case PointSpread::kAiry: {
			static const Profile airy = blurred_pattern(airy_profile, airy_encircled);
			return airy;
		}
		case PointSpread::kEye:
			return eye_profile(p_glare);
		default:
			return rows_of([](double t, double /*v*/) { return gaussian(t, 1.0); });
	}
}

} // namespace

PointSpreadTable::PointSpreadTable(PointSpread p_model, double p_glare)
		: m_nodes(profile_of(p_model, p_glare)) {
	m_nodes.resize(kBlocks * kRows * kColumns);
	for (std::size_t j = 0; j < kRows; ++j) {
		add_faded_light(j);
		add_cut_radii(j);
	}
}

double PointSpreadTable::fade(double p_part) {
	const double x = std::clamp(2.0 * p_part - 1.0, 0.0, 1.0);
	return 1.0 - x * x * (3.0 - 2.0 * x);
}

void PointSpreadTable::add_faded_light(std::size_t p_row) {
	// Encircled light of the profile as it is interpolated, cell by cell with Simpson's rule.
	const double *profile = &m_nodes[p_row * kColumns];
	std::vector<double> light(kColumns, 0.0);
	const auto ring = [](double t, double value) { return 2.0 * pi * t * value; };
	for (std::size_t i = 1; i < kColumns; ++i) {
		const auto column = static_cast<double>(i);
		const double inner = radius_at(column - 1.0);
		const double outer = radius_at(column);
		const double middle = radius_at(column - 0.5);
		// dt = t'(q) dq, and t' is linear in q: Simpson over q.
		const double slope_in = 4.0 * middle - 3.0 * inner - outer;
		const double slope_out = 3.0 * outer - 4.0 * middle + inner;
		light[i] = light[i - 1] +
				(ring(inner, profile[i - 1]) * slope_in +
						4.0 * ring(middle, 0.5 * (profile[i - 1] + profile[i])) * (outer - inner) +
						ring(outer, profile[i]) * slope_out) /
						6.0;
	}
	// By parts: the integral of light'(t) fade(t/T) is that of light(t) times the slope of fade.
	constexpr int kSteps = 64;
	for (std::size_t i = 0; i < kColumns; ++i) {
		const double reach = radius_at(static_cast<double>(i));
		double sum = 0.0;
		for (int k = 0; k < kSteps; ++k) {
			const double x = (k + 0.5) / kSteps;
			const double place = column_of(reach * 0.5 * (1.0 + x));
			const auto left = std::min(static_cast<std::size_t>(place), kColumns - 2);
			const double within = std::lerp(light[left], light[left + 1], place - static_cast<double>(left));
			sum += within * 6.0 * x * (1.0 - x) / kSteps;
		}
		m_nodes[(kRows + p_row) * kColumns + i] = sum;
	}
}

void PointSpreadTable::add_cut_radii(std::size_t p_row) {
	const double *profile = &m_nodes[p_row * kColumns];
	// A falling envelope over dark rings, as smooth as the wings' t^-3.
	std::vector<double> envelope(kColumns);
	double most = 0.0;
	for (std::size_t i = kColumns - 1; i > 0; --i) {
		const double t = radius_at(static_cast<double>(i));
		most = std::max(most, profile[i] * t * t * t);
		envelope[i] = std::min(most / (t * t * t), profile[0]);
	}
	envelope[0] = profile[0];
	std::size_t below = 1; // the first node whose envelope is below the limit
	for (std::size_t i = 0; i < kColumns; ++i) {
		const double octaves = kOctaves * static_cast<double>(i) / static_cast<double>(kColumns - 1);
		const double limit = std::exp2(-octaves);
		while (below < kColumns && envelope[below] >= limit) {
			++below;
		}
		double cut = kReach;
		if (below < kColumns) {
			const double part = std::log(std::max(envelope[below - 1], limit) / limit) /
					std::log(std::max(envelope[below - 1], limit) / envelope[below]);
			cut = std::lerp(
					radius_at(static_cast<double>(below - 1)), radius_at(static_cast<double>(below)), part);
		}
		// Never so near that the core would be cut.
		const double above = octaves + std::log2(profile[0]);
		m_nodes[(2 * kRows + p_row) * kColumns + i] = std::max(cut, std::clamp(3.0 + 0.25 * above, 3.0, 4.5));
	}
}

double PointSpreadTable::column_of(double p_t) {
	constexpr double kFar = 1.0 - kNearPart;
	const double part = std::clamp(p_t / kReach, 0.0, 1.0);
	return static_cast<double>(kColumns - 1) *
			(std::sqrt(kNearPart * kNearPart + 4.0 * kFar * part) - kNearPart) / (2.0 * kFar);
}

double PointSpreadTable::cut_radius(double p_contrast, double p_v) const {
	const double octaves = std::clamp(std::log2(p_contrast), 0.0, kOctaves);
	return at(2, static_cast<double>(kColumns - 1) * octaves / kOctaves, p_v);
}

double PointSpreadTable::at(std::size_t p_block, double p_column, double p_v) const {
	const double row = p_v * static_cast<double>(kRows - 1);
	const auto i = std::min(static_cast<std::size_t>(p_column), kColumns - 2);
	const auto j = std::min(static_cast<std::size_t>(row), kRows - 2);
	const double x = p_column - static_cast<double>(i);
	const double y = row - static_cast<double>(j);
	return std::lerp(std::lerp(node(p_block, i, j), node(p_block, i + 1, j), x),
			std::lerp(node(p_block, i, j + 1), node(p_block, i + 1, j + 1), x), y);
}

std::vector<float> PointSpreadTable::texels() const {
	std::vector<float> texels;
	texels.reserve(4 * kBlocks * (kRows - 1) * kColumns);
	for (std::size_t block = 0; block < kBlocks; ++block) {
		for (std::size_t j = 0; j + 1 < kRows; ++j) {
			for (std::size_t i = 0; i < kColumns; ++i) {
				const std::size_t next = std::min(i + 1, kColumns - 1);
				for (const std::size_t row : {j, j + 1}) {
					texels.push_back(static_cast<float>(node(block, i, row)));
					texels.push_back(static_cast<float>(node(block, next, row)));
				}
			}
		}
	}
	return texels;
}

} // namespace blackhole
