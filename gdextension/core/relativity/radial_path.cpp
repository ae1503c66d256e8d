// SPDX-License-Identifier: MIT
#include "core/relativity/radial_path.h"

#include <algorithm>
#include <cmath>

namespace blackhole {

Outcome<RadialPath> RadialPath::start(RadialFall fall, double start_radius, RadialWay way) {
	const Outcome<double> moves = fall.radial_celerity(start_radius, way);
	if (!moves) {
		return Outcome<RadialPath>::failure(moves.error);
	}
	RadialPath path(fall, start_radius, way);
	if (way == RadialWay::kInward) {
		path.duration_ = *fall.proper_time(start_radius, 0.0).value;
		return Outcome<RadialPath>::success(path);
	}
	const double top = fall.highest_radius();
	if (std::isinf(top)) {
		path.duration_ = path.turn_time_ = top;
		return Outcome<RadialPath>::success(path);
	}
	path.turn_time_ = *fall.proper_time(std::min(start_radius, top), top).value;
	path.duration_ = path.turn_time_ + *fall.proper_time(top, 0.0).value;
	return Outcome<RadialPath>::success(path);
}

Outcome<double> RadialPath::proper_time_to(double radius) const {
	const bool above = radius > start_radius_;
	if (way_ == RadialWay::kInward || above) {
		if (above && way_ == RadialWay::kInward) {
			return Outcome<double>::failure("this fall starts below that radius and goes inward");
		}
		return fall_.proper_time(start_radius_, radius);
	}
	if (radius == start_radius_) {
		return Outcome<double>::success(0.0);
	}
	if (std::isinf(duration_)) {
		return Outcome<double>::failure("this motion escapes and never is below its start");
	}
	Outcome<double> back = fall_.proper_time(fall_.highest_radius(), radius);
	if (back) {
		*back.value += turn_time_;
	}
	return back;
}

} // namespace blackhole
