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

/// What is the same for every eye at the ends of the bins: the angles of an order's rays, and their sines.
template <std::size_t kEnds>
struct BinEnds {
	std::array<ShaderLensing::TableAngle, kEnds> angle;
	std::array<double, kEnds> sine;

	explicit BinEnds(int order) {
		const bool odd = order % 2 == 1;
		const double turns = kPi * static_cast<double>(order + (odd ? 1 : 0));
		for (std::size_t i = 0; i < kEnds; ++i) {
			const double at = kPi * static_cast<double>(i) / (kEnds - 1);
			const double beside = std::max(at, order == 0 ? kNearlyNothing : 0.0);
			angle[i] = ShaderLensing::table_angle(odd ? turns - at : turns + beside);
			sine[i] = i == kEnds - 1 ? 0.0 : std::sin(beside);
		}
	}
};

/// Of a boost's Doppler factors over all directions at angles between two from the hole: the smallest and
/// largest.
class DopplerRange {
public:
	explicit DopplerRange(const LocalObserver &eye)
			: size(glm::length(eye.celerity)), gamma(std::hypot(1.0, size)) {
		const double inward = -glm::dot(eye.celerity, eye.outward);
		angle = std::atan2(std::sqrt(std::max(size * size - inward * inward, 0.0)), inward);
	}

	/// gamma + |w| cos, with the angle between direction and motion within the bin's reach of its least and
	/// largest.
	[[nodiscard]] double largest(double xi_from, double xi_to) const {
		if (size == 0.0) {
			return 1.0;
		}
		const double beside = std::clamp(angle, xi_from, xi_to);
		return gamma + size * std::cos(angle - beside);
	}
	[[nodiscard]] double smallest(double xi_from, double xi_to) const {
		if (size == 0.0) {
			return 1.0;
		}
		const double opposite = std::clamp(kPi - angle, xi_from, xi_to);
		const double along = size * std::cos(angle + opposite);
		return along >= 0.0 ? gamma + along : std::max(gamma + along, 1.0 / (gamma + size));
	}

private:
	double size;
	double gamma;
	double angle = 0.0; ///< of the motion from the direction to the hole
};

} // namespace

LocalObserver drawn_observer(const glm::dvec3 &position, const ObserverField &observer) {
	Outcome<LocalObserver> at = local_observer(observer, position);
	if (!at && observer.motion == ObserverMotion::kInfall && glm::length(position) > 1.0) {
		at = local_observer(ObserverMotion::kStatic, position);
	}
	if (!at && observer.motion == ObserverMotion::kVelocity) {
		ObserverField velocity = observer;
		velocity.relative_to_static = false;
		at = local_observer(velocity, position);
	}
	return at ? *at.value : *local_observer(ObserverMotion::kRain, position).value;
}

ImageBound::ImageBound(const LocalObserver &eye, int order, const LensingTables &tables,
		const std::function<double(double, double)> &gain)
		: outward(eye.outward) {
	using Ends = BinEnds<kBins + 1>;
	static const std::array<Ends, 4> kOfOrders = {Ends(0), Ends(1), Ends(2), Ends(3)};
	const Ends &ends = kOfOrders.at(static_cast<std::size_t>(order));
	const std::array<double, kBins + 1> &sine = ends.sine;
	std::array<ShaderLensing::Ray, kBins + 1> rays; // NOLINT(cppcoreguidelines-pro-type-member-init)
	ShaderLensing(tables).rays_of_angles(eye.u, ends.angle.data(), rays.size(), rays.data());
	std::array<double, kBins + 1> spread{}; // magnification times sin(angle), a smooth function
	std::array<double, kBins + 1> redshift{};
	std::array<double, kBins + 1> xi{};
	const double k2 = eye.kappa * eye.kappa;
	for (std::size_t i = 0; i <= kBins; ++i) {
		const double sigma = rays[i].sigma;
		const double s2 = sigma * sigma;
		const double sum = k2 + s2;
		spread[i] = 4.0 * k2 * sigma * std::abs(double{rays[i].slope}) / (sum * sum);
		redshift[i] = sum / (eye.kappa * (1.0 - eye.u + s2));
		xi[i] = 2.0 * std::atan(sigma / eye.kappa);
	}
	const DopplerRange doppler(eye);
	for (std::size_t i = 0; i < kBins; ++i) {
		const double xi_from = std::min(xi[i], xi[i + 1]);
		const double xi_to = std::max(xi[i], xi[i + 1]);
		const double least_doppler = doppler.smallest(xi_from, xi_to);
		const double least_sine = std::min(sine[i], sine[i + 1]);
		double magnification = kInfinity;
		if (least_sine > 0.0) {
			// Where sin(angle) itself carries the smooth function, as for the direct image, the ratio bounds
			// it.
			magnification = order == 0 ? std::max(spread[i] / sine[i], spread[i + 1] / sine[i + 1])
									   : std::max(spread[i], spread[i + 1]) / least_sine;
		}
		const double brighter = gain(xi_from, xi_to);
		log_magnification[i] = brighter > 0.0
				? std::log2(kReserve * magnification * brighter / (least_doppler * least_doppler))
				: -kInfinity;
		log_redshift[i] = std::log(std::max(redshift[i], redshift[i + 1]) * doppler.largest(xi_from, xi_to));
		never_redshifted = never_redshifted && std::min(redshift[i], redshift[i + 1]) * least_doppler >= 1.0;
	}
}

double ImageBound::least_brightening() const {
	if (!never_redshifted) {
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
	double redshift = -kInfinity;
	for (std::size_t i = std::min(first, kBins - 1); i < end; ++i) {
		if (log_magnification[i] > -kInfinity) {
			magnification = std::max(magnification, log_magnification[i]);
			redshift = std::max(redshift, log_redshift[i]);
		}
	}
	if (magnification == -kInfinity) {
		return -kInfinity;
	}
	return kMagnitudesPerLog2 * (magnification + group.shift.log2_gain(redshift));
}

} // namespace blackhole
