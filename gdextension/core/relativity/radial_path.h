// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"
#include "core/relativity/radial_fall.h"

namespace blackhole {

/// A radial free fall from a start on, with the turn of what is thrown up too slowly to escape; a ride that
/// can be asked at any of its times, so paused, slowed and reversed. Units and errors of RadialFall.
class RadialPath {
public:
	/// Fails where the motion does not pass start_radius this way, and for a start at the centre.
	static Outcome<RadialPath> start(
			RadialFall fall, double start_radius, RadialWay way = RadialWay::kInward);

	[[nodiscard]] const RadialFall &fall() const { return fall_; }
	[[nodiscard]] double start_radius() const { return start_radius_; }

	/// Proper time from the start to r = 0; infinite for what escapes.
	[[nodiscard]] double duration() const { return duration_; }

	/// Proper time from the start until it first is at `radius`. Fails when it never is.
	[[nodiscard]] Outcome<double> proper_time_to(double radius) const;

	/// Fails before the start, at the end and after it.
	[[nodiscard]] Outcome<RadialMoment> at(double proper_time) const {
		return fall_.moment_after(start_radius_, proper_time, way_);
	}

private:
	RadialPath(RadialFall fall, double start_radius, RadialWay way)
			: fall_(fall), start_radius_(start_radius), way_(way) {}

	RadialFall fall_;
	double start_radius_;
	RadialWay way_;
	double duration_ = 0.0;
	/// Proper time until the turn.
	double turn_time_ = 0.0;
};

} // namespace blackhole
