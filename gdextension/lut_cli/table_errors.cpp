// SPDX-License-Identifier: MIT
#include "lut_cli/table_errors.h"

#include "core/relativity/magnification.h"
#include "core/relativity/observer.h"
#include "core/relativity/view_angle.h"
#include "lut_cli/ray_source.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace blackhole {
namespace {

struct Sample {
	double u;
	double phi;
};

/// The same numbers on every platform for the same seed: only the generator itself is standardised.
class SampleStream {
public:
	explicit SampleStream(std::uint64_t seed) : generator(seed) {}

	Sample next() {
		constexpr double kMaxPhi = 8.0 * std::numbers::pi;
		const double u = log_uniform(1e-10, 20.0);
		switch (count++ % 3) {
			case 0:
				return {u, std::max(kMaxPhi * uniform(), 1e-4)};
			case 1:
				return {u, log_uniform(1e-4, kMaxPhi)};
			default: {
				const double side = uniform() < 0.5 ? -1.0 : 1.0;
				return {u, std::numbers::pi + side * log_uniform(1e-7, 1.0)};
			}
		}
	}

private:
	double uniform() { return static_cast<double>(generator() >> 11) * 0x1p-53; }
	double log_uniform(double low, double high) { return low * std::exp(uniform() * std::log(high / low)); }

	std::mt19937_64 generator;
	std::uint64_t count = 0;
};

/// The errors of one kind, with their places.
class ErrorList {
public:
	ErrorList(const char *name, double limit) {
		summary.name = name;
		summary.limit = limit;
	}

	void add(double error, Sample at) {
		if (!(error <= summary.largest)) { // also where it is no number
			summary.largest = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
			summary.u = at.u;
			summary.phi = at.phi;
		}
		errors.push_back(error);
	}

	TableError result() {
		const auto rank = static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(errors.size() - 1));
		std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
		summary.permille = errors[static_cast<std::size_t>(rank)];
		return summary;
	}

private:
	TableError summary;
	std::vector<double> errors;
};

} // namespace

std::vector<TableError> measure_table_errors(const LensingTables &tables, int samples, std::uint64_t seed) {
	const ExactRays exact;
	const TabulatedRays tabulated(tables);
	ErrorList angle("xi [rad]", 1e-5);
	ErrorList allowance("xi / min(1e-4 rad, 1e-3 xi)", 0.2);
	ErrorList magnification("magnification, relative", 3e-3);
	ErrorList forward("forward Phi [rad]", 2e-4);
	ErrorList forward_angle("forward Phi as an error of xi [rad]", 1e-5);
	SampleStream stream(seed);
	for (int i = 0; i < std::max(samples, 1); ++i) {
		const Sample at = stream.next();
		const ImageDirection truth = exact.image(at.u, at.phi);
		const ImageDirection found = tabulated.image(at.u, at.phi);
		const double phi_error = std::abs(tabulated.angle(at.u, truth.y).phi - at.phi);
		for (const ObserverMotion motion : {ObserverMotion::kRain, ObserverMotion::kStatic}) {
			const double kappa = radial_kappa(at.u, motion);
			if (!(kappa > 0.0)) {
				continue;
			}
			const double xi = view_angle(at.u, truth.y, kappa);
			const double xi_error = std::abs(view_angle(at.u, found.y, kappa) - xi);
			angle.add(xi_error, at);
			allowance.add(xi_error / std::min(1e-4, 1e-3 * xi), at);
			const double mu = radial_magnification(at.u, truth, kappa, 1.0);
			magnification.add(std::abs(radial_magnification(at.u, found, kappa, 1.0) / mu - 1.0), at);
			forward_angle.add(phi_error * std::abs(truth.slope) * view_angle_slope(at.u, truth.y, kappa), at);
		}
		forward.add(phi_error, at);
	}
	return {angle.result(), allowance.result(), magnification.result(), forward.result(),
			forward_angle.result()};
}

} // namespace blackhole
