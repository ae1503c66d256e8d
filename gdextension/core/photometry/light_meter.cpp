// SPDX-License-Identifier: MIT
#include "core/photometry/light_meter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blackhole {

namespace {

/// Coprime to the number of directions: steps by it come by all, far from each other.
constexpr std::size_t kStride = 89;
/// How much less the corners count than the centre: exp(-2).
constexpr double kFallOff = 2.0;

/// Part of the picture's solid angle that lies nearer to the axis.
double part_within(std::size_t p_number) {
	return (static_cast<double>(p_number) + 0.5) / LightMeter::kDirections;
}

std::array<double, LightMeter::kDirections> make_weights() {
	std::array<double, LightMeter::kDirections> weights{};
	double sum = 0.0;
	for (std::size_t i = 0; i < weights.size(); ++i) {
		weights[i] = std::exp(-kFallOff * part_within(i));
		sum += weights[i];
	}
	for (double &weight : weights) {
		weight /= sum;
	}
	return weights;
}

} // namespace

glm::dvec3 LightMeter::direction(std::size_t p_number, double p_half_angle) {
	const double half_sine = std::sin(0.5 * p_half_angle);
	const double versine = 2.0 * half_sine * half_sine * part_within(p_number); // 1 - cos
	const double sine = std::sqrt(versine * (2.0 - versine));
	const double turn = 2.0 * std::numbers::pi * static_cast<double>(p_number) / std::numbers::phi;
	return {sine * std::cos(turn), sine * std::sin(turn), 1.0 - versine};
}

std::size_t LightMeter::next() {
	m_next = (m_next + kStride) % kDirections;
	return m_next;
}

double LightMeter::mean() const {
	static const std::array<double, kDirections> weights = make_weights();
	double plain = 0.0;
	for (std::size_t i = 0; i < kDirections; ++i) {
		plain += weights[i] * m_luminance[i];
	}
	if (!(plain > 0.0)) {
		return 0.0;
	}
	const double veil = kVeil * plain;
	double logarithm = 0.0;
	for (std::size_t i = 0; i < kDirections; ++i) {
		logarithm += weights[i] * std::log2(m_luminance[i] + veil);
	}
	const double brightest = *std::max_element(m_luminance.begin(), m_luminance.end());
	return std::max(std::exp2(logarithm) / (1.0 + kVeil), brightest / kHeadroom);
}

} // namespace blackhole
