// SPDX-License-Identifier: MIT
#include "core/culling/image_bound.h"

#include "core/tables/shader_lensing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace blackhole {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMagnitudesPerLog2 = 2.5 * (std::numbers::ln2 / std::numbers::ln10);
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Covers the tables' error (0.3 %) and the curvature between the ends of a bin.
constexpr double kReserve = 1.03;
// The direct image of a star straight above: a smooth function's limit is taken here, radians.
constexpr double kNearlyNothing = 1e-3;

double redshift_of(const EyeBound &eye, double sigma) {
	if (eye.is_static) {
		return 1.0 / std::sqrt(1.0 - eye.u);
	}
	const double k2 = eye.kappa * eye.kappa;
	const double s2 = sigma * sigma;
	return 1.0 / (1.0 - std::sqrt(eye.u) * (k2 - s2) / (k2 + s2));
}

} // namespace

EyeBound eye_bound(const glm::dvec3 &position, ObserverMotion motion) {
	EyeBound eye;
	const double r = glm::length(position);
	eye.outward = position / r;
	eye.u = 1.0 / r;
	eye.is_static = motion == ObserverMotion::kStatic && eye.u < 1.0;
	eye.kappa = eye.is_static ? std::sqrt(1.0 - eye.u) : 1.0 + std::sqrt(eye.u);
	return eye;
}

ImageBound::ImageBound(const EyeBound &eye, int order, const LensingTables &tables,
		const std::function<double(double)> &gain)
		: outward(eye.outward) {
	const ShaderLensing lensing(tables);
	const bool odd = order % 2 == 1;
	const double turns = kPi * static_cast<double>(order + (odd ? 1 : 0));
	std::array<double, kBins + 1> spread{}; // magnification times sin(angle), a smooth function
	std::array<double, kBins + 1> sine{};
	std::array<double, kBins + 1> xi{};
	for (std::size_t i = 0; i <= kBins; ++i) {
		const double angle = kPi * static_cast<double>(i) / kBins;
		const double smallest = order == 0 ? kNearlyNothing : 0.0;
		const double phi = odd ? turns - angle : turns + std::max(angle, smallest);
		const ShaderLensing::Ray ray = lensing.ray_of_angle(eye.u, phi);
		const double sigma = ray.sigma;
		const double k2 = eye.kappa * eye.kappa;
		const double sum = k2 + sigma * sigma;
		spread[i] = 4.0 * k2 * sigma * std::abs(double{ray.slope}) / (sum * sum);
		sine[i] = i == kBins ? 0.0 : std::sin(std::max(angle, smallest));
		log_redshift[i] = std::log(redshift_of(eye, sigma));
		xi[i] = 2.0 * std::atan(sigma / eye.kappa);
	}
	for (std::size_t i = 0; i < kBins; ++i) {
		const double least_sine = std::min(sine[i], sine[i + 1]);
		double magnification = kInfinity;
		if (least_sine > 0.0) {
			// Where sin(angle) itself carries the smooth function, as for the direct image, the ratio bounds
			// it.
			magnification = order == 0 ? std::max(spread[i] / sine[i], spread[i + 1] / sine[i + 1])
									   : std::max(spread[i], spread[i + 1]) / least_sine;
		}
		log_magnification[i] = std::log2(kReserve * magnification * gain(std::max(xi[i], xi[i + 1])));
	}
}

double ImageBound::least_brightening() const {
	if (*std::min_element(log_redshift.begin(), log_redshift.end()) < 0.0) {
		return -kInfinity; // redshift dims cool stars without limit
	}
	return kMagnitudesPerLog2 * *std::min_element(log_magnification.begin(), log_magnification.end());
}

double ImageBound::brightening(const StarGroup &group, double slack) const {
	const double angle = std::acos(std::clamp(glm::dot(outward, group.centre), -1.0, 1.0));
	const double reach = group.angular_radius + slack;
	constexpr double kBinsPerRadian = kBins / kPi;
	const auto first = static_cast<std::size_t>(std::max((angle - reach) * kBinsPerRadian, 0.0));
	const auto end = std::min(static_cast<std::size_t>((angle + reach) * kBinsPerRadian) + 1, kBins);
	double magnification = -kInfinity;
	for (std::size_t i = std::min(first, kBins - 1); i < end; ++i) {
		magnification = std::max(magnification, log_magnification[i]);
	}
	const double redshift = std::max(log_redshift[std::min(first, kBins - 1)], log_redshift[end]);
	return kMagnitudesPerLog2 * (magnification + group.shift.log2_gain(redshift));
}

} // namespace blackhole
