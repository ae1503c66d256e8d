// SPDX-License-Identifier: MIT
#include "core/photometry/colour_index.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "core/photometry/constants.h"

namespace blackhole {

namespace {

// Bessell 1990, table 2: every 10 nm, B from 360 nm and V from 470 nm.
constexpr std::array kBandB = {0.0, 0.030, 0.134, 0.567, 0.920, 0.978, 1.000, 0.978, 0.935, 0.853, 0.740,
		0.640, 0.536, 0.424, 0.325, 0.235, 0.150, 0.095, 0.043, 0.009, 0.0};
constexpr std::array kBandV = {0.0, 0.030, 0.163, 0.458, 0.780, 0.967, 1.000, 0.973, 0.898, 0.792, 0.684,
		0.574, 0.461, 0.359, 0.270, 0.197, 0.135, 0.081, 0.045, 0.025, 0.017, 0.013, 0.009, 0.0};
// Flux of a star of magnitude 0 (Bessell, Castelli & Plez 1998), 1e-11 erg/(cm2 s A).
constexpr double kZeroFluxB = 632.0;
constexpr double kZeroFluxV = 363.1;

/// ln of the mean Planck radiance through a band that starts at p_start metres, up to a constant.
double log_mean_radiance(std::span<const double> p_band, double p_start, double p_temperature) {
	constexpr double kReference = 550e-9;
	const double x_reference = kSecondRadiationConstant / (kReference * p_temperature);
	double sum = 0.0;
	double weights = 0.0;
	for (std::size_t i = 0; i < p_band.size(); ++i) {
		const double wavelength = p_start + 10e-9 * static_cast<double>(i);
		const double x = kSecondRadiationConstant / (wavelength * p_temperature);
		sum += p_band[i] * std::pow(wavelength / kReference, -5.0) * std::exp(x_reference - x) /
				-std::expm1(-x);
		weights += p_band[i];
	}
	return std::log(sum / weights) - x_reference;
}

double node_temperature(double p_index, std::size_t p_nodes) {
	const double fraction = p_index / static_cast<double>(p_nodes - 1);
	return ColourTemperature::kCoolest *
			std::pow(ColourTemperature::kHottest / ColourTemperature::kCoolest, fraction);
}

} // namespace

double black_body_b_minus_v(double p_temperature) {
	const double difference = log_mean_radiance(kBandB, 360e-9, p_temperature) -
			log_mean_radiance(kBandV, 470e-9, p_temperature);
	return 2.5 * (std::log10(kZeroFluxB / kZeroFluxV) - difference / std::log(10.0));
}

ColourTemperature::ColourTemperature() {
	for (std::size_t i = 0; i < kNodes; ++i) {
		m_colour[i] = black_body_b_minus_v(node_temperature(static_cast<double>(i), kNodes));
	}
}

double ColourTemperature::operator()(double p_b_minus_v) const {
	const double colour = std::clamp(p_b_minus_v, m_colour.back(), m_colour.front());
	const auto after = std::lower_bound(m_colour.begin() + 1, m_colour.end() - 1, colour, std::greater<>());
	const auto index = static_cast<double>(after - m_colour.begin());
	return node_temperature(index - (colour - *after) / (*(after - 1) - *after), kNodes);
}

double ballesteros_temperature(double p_b_minus_v) {
	const double x = 0.92 * std::clamp(p_b_minus_v, -0.4, 2.0);
	return 4600.0 * (1.0 / (x + 1.7) + 1.0 / (x + 0.62));
}

} // namespace blackhole
