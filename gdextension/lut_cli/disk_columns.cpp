// SPDX-License-Identifier: MIT
#include "lut_cli/disk_columns.h"

#include "core/disk/disk_crossing.h"
#include "core/disk/page_thorne.h"
#include "core/relativity/light_ray.h"
#include "core/relativity/observer.h"
#include "core/relativity/redshift.h"
#include "core/relativity/view_angle.h"

#include <limits>

namespace blackhole::disk_columns {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kOrders = 3;

std::vector<double> crossings(std::span<const double> inputs, ObserverMotion motion, double y) {
	std::vector<double> row(inputs.begin(), inputs.begin() + 4);
	const DiskSight sight{inputs[0], y, inputs[1], inputs[3]};
	const double a = LightRay<double>(sight.u, y).a;
	const double observed = radial_redshift(sight.u, y, radial_kappa(sight.u, motion));
	for (int order = 0; order < kOrders; ++order) {
		const double r = disk_crossing_radius(sight, order);
		row.push_back(r);
		row.push_back(observed * disk_redshift(r, a, sight.inclination, sight.azimuth));
	}
	return row;
}

} // namespace

std::vector<double> disk_static(const RaySource & /*rays*/, std::span<const double> inputs) {
	if (!(inputs[0] < 1.0)) {
		return {inputs[0], inputs[1], inputs[2], inputs[3], kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
	}
	return crossings(inputs, ObserverMotion::kStatic, static_sigma_offset(inputs[0], inputs[2]));
}

std::vector<double> disk_rain(const RaySource & /*rays*/, std::span<const double> inputs) {
	return crossings(inputs, ObserverMotion::kRain, rain_sigma_offset(inputs[0], inputs[2]));
}

std::vector<double> page_thorne(const RaySource & /*rays*/, std::span<const double> inputs) {
	const double flux = page_thorne_flux(inputs[0]);
	return {inputs[0], flux, flux / page_thorne_flux(kHottestRing), page_thorne_temperature(inputs[0])};
}

} // namespace blackhole::disk_columns
