// SPDX-License-Identifier: MIT
#pragma once

#include "lut_cli/ray_source.h"

#include <span>
#include <vector>

namespace blackhole::disk_columns {

/// The columns of the reference tables of the disk, exactly in double precision. Angles in radians, lengths
/// in r_s.

/// u_o, inc, xi, psi -> u_o,inc,xi,psi,r0,g0,r1,g1,r2,g2: where a static observer's line of sight meets the
/// plane, and nu_obs/nu_em of gas on circular orbits there.
std::vector<double> disk_static(const RaySource &rays, std::span<const double> inputs);
/// The same for the rain observer.
std::vector<double> disk_rain(const RaySource &rays, std::span<const double> inputs);
/// r -> r,F_shape,F_rel,T_rel
std::vector<double> page_thorne(const RaySource &rays, std::span<const double> inputs);
/// r, a, tilt, outgoing (1 or 0) -> r,a,tilt,outgoing,redshift: nu_infinity/nu_emitted of gas that plunges
/// from the last stable orbit (core/disk/plunging_gas.h).
std::vector<double> plunging_gas(const RaySource &rays, std::span<const double> inputs);

} // namespace blackhole::disk_columns
