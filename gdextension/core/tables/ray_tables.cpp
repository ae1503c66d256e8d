// SPDX-License-Identifier: MIT
#include "core/tables/ray_tables.h"

#include "core/relativity/critical.h"
#include "core/tables/ray_axis.h"

#include <array>
#include <cmath>
#include <cstddef>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

namespace blackhole {
namespace {

/// Second derivative of the plunging rays' span by L at L = 0.
constexpr double kSpanBend = -2.0 *
		(kRaySpanNearlyStraight.height / (kRaySpanNearlyStraight.bend * kRaySpanNearlyStraight.bend) +
				kRaySpanBent.height / (kRaySpanBent.bend * kRaySpanBent.bend));

/// The ray of one column in scaled variables that keep their size for all impact parameters. With x = 1 -
/// exp(-L): turning rays have U = u/a over s = eta, plunging ones U = u over s = a eta; both obey U'' = beta
/// U^2 - alpha U, U = 0 and U' = 1 at s = 0, and u/(a eta) = U/s.
struct ScaledRay {
	double alpha;
	double beta;
	double alpha_slope; ///< by x
	double beta_slope;
	double span;       ///< s of the last row
	double span_slope; ///< by L
	double x_slope;    ///< dx/dL

	ScaledRay(bool turns, double nearness) {
		const double x = -std::expm1(-nearness);
		x_slope = std::exp(-nearness);
		const RaySpan limit = ray_span(turns, nearness);
		if (turns) {
			alpha = 1.0;
			alpha_slope = 0.0;
			beta = 1.5 * kCriticalA * x;
			beta_slope = 1.5 * kCriticalA;
			span = limit.eta;
			span_slope = limit.slope;
			return;
		}
		alpha = x * x / (kCriticalA * kCriticalA);
		alpha_slope = 2.0 * x / (kCriticalA * kCriticalA);
		beta = 1.5 * alpha;
		beta_slope = 1.5 * alpha_slope;
		// span = a eta = a_c eta/x, where eta and x vanish together.
		if (nearness < 1e-9) {
			span = kCriticalA * limit.slope;
			span_slope = kCriticalA * (0.5 * limit.slope + 0.5 * kSpanBend);
			return;
		}
		span = kCriticalA * limit.eta / x;
		span_slope = span * (limit.slope / limit.eta - x_slope / x);
	}
};

/// U, U', their derivatives by x, the scaled delay (a V, of plunging rays a^2 V) and its derivative by x.
enum Part : std::size_t { kU, kSlope, kVaried, kVariedSlope, kDelay, kVariedDelay, kParts };
using RayState = std::array<double, kParts>;

RayState rates(const ScaledRay &ray, const RayState &at) {
	const double pace = 1.0 / (1.0 + at[kSlope]);
	RayState rate;
	rate[kU] = at[kSlope];
	rate[kSlope] = at[kU] * (ray.beta * at[kU] - ray.alpha);
	rate[kVaried] = at[kVariedSlope];
	rate[kVariedSlope] = at[kVaried] * (2.0 * ray.beta * at[kU] - ray.alpha) +
			at[kU] * (ray.beta_slope * at[kU] - ray.alpha_slope);
	rate[kDelay] = pace;
	rate[kVariedDelay] = -at[kVariedSlope] * pace * pace;
	return rate;
}

/// A function of s and x with its derivatives.
struct Sample {
	double value;
	double by_s;
	double by_x;
};

/// A texel at the row p = s/span, without its mixed derivative.
void put_texel(float *texel, const Sample &at, double p, const ScaledRay &ray, double column_slope) {
	texel[0] = static_cast<float>(at.value);
	texel[1] = static_cast<float>((at.by_x * ray.x_slope + at.by_s * p * ray.span_slope) * column_slope);
	texel[2] = static_cast<float>(at.by_s * ray.span / (kRayHalfRows - 1.0));
}

/// sqrt(s/U)
Sample radius_sample(const RayState &at, double s) {
	const double value = std::sqrt(s / at[kU]);
	return {value, 0.5 * value * (1.0 / s - at[kSlope] / at[kU]), -0.5 * value * at[kVaried] / at[kU]};
}

/// 2/s times the delay
Sample delay_sample(const RayState &at, double s) {
	const double value = 2.0 * at[kDelay] / s;
	return {value, (2.0 / (1.0 + at[kSlope]) - value) / s, 2.0 * at[kVariedDelay] / s};
}

/// Of the integrator of eighth order: its error is below 1e-12 then.
constexpr int kStepsPerRow = 8;

void bake_column(bool turns, int column, RayTables &tables) {
	const ScaledRay ray(turns, ray_column_nearness(column));
	const double slope = ray_column_slope(column);
	const auto system = [&ray](const RayState &at, RayState &rate, double /*s*/) { rate = rates(ray, at); };
	boost::numeric::odeint::runge_kutta_fehlberg78<RayState> stepper;
	RayState at{0.0, 1.0, 0.0, 0.0, 0.0, 0.0};
	for (int row = 0; row < kRayHalfRows; ++row) {
		const int line = turns ? row : kRayHalfRows + row;
		const auto place = std::size_t{4} * static_cast<std::size_t>(line * kRayColumns + column);
		float *radius = tables.radius.data() + place;
		float *delay = tables.delay.data() + place;
		if (row == 0) {
			radius[0] = delay[0] = 1.0F; // and without slopes
			continue;
		}
		const double p = row / (kRayHalfRows - 1.0);
		const double s = p * ray.span;
		for (int step = 0; step < kStepsPerRow; ++step) {
			stepper.do_step(system, at, 0.0, ray.span / ((kRayHalfRows - 1.0) * kStepsPerRow));
		}
		put_texel(radius, radius_sample(at, s), p, ray, slope);
		put_texel(delay, delay_sample(at, s), p, ray, slope);
	}
}

/// The mixed derivatives: those by the row, differentiated along the columns.
void mix(std::vector<float> &table) {
	for (int row = 0; row < kRayRows; ++row) {
		const auto by_row = [&table, row](int column) {
			return double{table[std::size_t{4} * static_cast<std::size_t>(row * kRayColumns + column) + 2]};
		};
		for (int column = 0; column < kRayColumns; ++column) {
			double slope = 0.0;
			if (column == 0) {
				slope = -1.5 * by_row(0) + 2.0 * by_row(1) - 0.5 * by_row(2);
			} else if (column == kRayColumns - 1) {
				slope = 1.5 * by_row(column) - 2.0 * by_row(column - 1) + 0.5 * by_row(column - 2);
			} else if (column == 1 || column == kRayColumns - 2) {
				slope = 0.5 * (by_row(column + 1) - by_row(column - 1));
			} else {
				slope = (8.0 * (by_row(column + 1) - by_row(column - 1)) -
								(by_row(column + 2) - by_row(column - 2))) /
						12.0;
			}
			table[std::size_t{4} * static_cast<std::size_t>(row * kRayColumns + column) + 3] =
					static_cast<float>(slope);
		}
	}
}

} // namespace

RayTables bake_ray_tables(const std::function<bool(double)> &progress) {
	RayTables tables;
	constexpr std::size_t kFloats = std::size_t{4} * kRayColumns * kRayRows;
	tables.radius.resize(kFloats);
	tables.delay.resize(kFloats);
	for (int column = 0; column < kRayColumns; ++column) {
		if (progress && !progress(column / double{kRayColumns})) {
			return {};
		}
		bake_column(true, column, tables);
		bake_column(false, column, tables);
	}
	mix(tables.radius);
	mix(tables.delay);
	if (progress && !progress(1.0)) {
		return {};
	}
	return tables;
}

} // namespace blackhole
