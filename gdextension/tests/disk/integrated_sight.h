// SPDX-License-Identifier: MIT
#pragma once

#include "relativity/brute_force_geodesic.h"

namespace blackhole::test {

/// A line of sight followed backwards step by step from the eye, with its meetings with a plane and the time
/// that light has been on its way since.
class IntegratedSight {
public:
	/// From u = r_s/r with this du/dphi.
	IntegratedSight(double u, double slope);

	/// r [r_s] at the orbital angle chi [rad] from the eye, NaN where the way has ended before: at infinity,
	/// at the horizon, or where an observer within it cannot have light from. Angles must rise.
	double radius_at(double chi);
	/// Painleve-Gullstrand time [r_s/c] from the last place asked for to the eye.
	double delay() const { return time; }
	/// Whether the light leaves that place on its way out.
	bool is_outgoing() const { return orbit.slope() > 0.0; }
	/// How near to its end the way is, in u.
	double margin() const;

private:
	double deepest;
	OrbitIntegrator orbit;
	double at = 0.0;
	double time = 0.0;
	bool ended = false;
};

/// The angle chi_0 [rad], 0 to pi, between the eye and the first meeting with a disk seen at this inclination
/// and azimuth (see core/disk/disk_crossing.h), from vectors.
double first_meeting_angle(double inclination, double azimuth);

} // namespace blackhole::test
