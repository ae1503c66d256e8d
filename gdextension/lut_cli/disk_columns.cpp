// SPDX-License-Identifier: MIT
#include "lut_cli/disk_columns.h"

#include "core/disk/page_thorne.h"
#include "core/disk/plunging_gas.h"
#include "core/relativity/not_a_number.h"
#include "core/relativity/observer.h"

namespace blackhole::disk_columns {
namespace {

constexpr int kOrders = 3;

std::vector<double> crossings(const RaySource &rays, std::span<const double> inputs, ObserverMotion motion) {
	std::vector<double> row(inputs.begin(), inputs.begin() + 4);
	const bool exists = motion != ObserverMotion::kStatic || inputs[0] < 1.0;
	for (int order = 0; order < kOrders; ++order) {
		const DiskView view{inputs[0], inputs[1], inputs[2], inputs[3], motion};
		const DiskMeeting meeting = exists ? rays.disk(view, order) : DiskMeeting{kNaN, kNaN};
		row.push_back(meeting.r);
		row.push_back(meeting.redshift);
	}
	return row;
}

} // namespace

std::vector<double> disk_static(const RaySource &rays, std::span<const double> inputs) {
	return crossings(rays, inputs, ObserverMotion::kStatic);
}

std::vector<double> disk_rain(const RaySource &rays, std::span<const double> inputs) {
	return crossings(rays, inputs, ObserverMotion::kRain);
}

std::vector<double> page_thorne(const RaySource & /*rays*/, std::span<const double> inputs) {
	const double flux = page_thorne_flux(inputs[0]);
	return {inputs[0], flux, flux / page_thorne_flux(kHottestRing), page_thorne_temperature(inputs[0])};
}

std::vector<double> plunging_gas(const RaySource & /*rays*/, std::span<const double> inputs) {
	std::vector<double> row(inputs.begin(), inputs.begin() + 4);
	row.push_back(plunging_redshift(inputs[0], {inputs[1], inputs[2], inputs[3] == 1.0}));
	return row;
}

} // namespace blackhole::disk_columns
