// SPDX-License-Identifier: MIT
#pragma once

#include "lut_cli/ray_source.h"

#include <span>
#include <vector>

namespace blackhole::ray_columns {

/// The columns of the reference tables from their inputs, exactly in double precision; nan where no such
/// observer or no such ray exists. Angles in radians, lengths in r_s.

/// u_o, Phi -> u_o,Phi,sigma,sigma_minus_crit,a,xi_rain,xi_rain_minus_shadow,dxi_rain_dPhi,mu_rain,g_rain
std::vector<double> inverse_rain(const RaySource &rays, std::span<const double> inputs);
/// ... and xi_static,xi_static_minus_shadow,dxi_static_dPhi,mu_static
std::vector<double> inverse_static(const RaySource &rays, std::span<const double> inputs);
/// u_o, xi_static -> u_o,xi_static,xi_minus_shadow,Phi,dPhi_dxi,a,sigma
std::vector<double> forward_static(const RaySource &rays, std::span<const double> inputs);
/// u_o, xi_rain -> u_o,xi_rain,xi_minus_shadow,Phi,dPhi_dxi,a,sigma,g_rain
std::vector<double> forward_rain(const RaySource &rays, std::span<const double> inputs);
/// u_o, phi, order -> u_o,phi,order,Phi,side,xi_rain,mu_rain,g_rain,xi_static,mu_static,g_static
std::vector<double> images(const RaySource &rays, std::span<const double> inputs);
/// u_o, n -> u_o,n,xi_rain,xi_rain_minus_shadow,xi_static,a
std::vector<double> rings(const RaySource &rays, std::span<const double> inputs);
/// u_o -> u_o,xi_shadow_rain,xi_shadow_static
std::vector<double> shadow(const RaySource &rays, std::span<const double> inputs);
/// b -> b,b_over_bc_minus_1,alpha,alpha_weak4,alpha_strong,r_min
std::vector<double> deflection(const RaySource &rays, std::span<const double> inputs);

/// u_o, xi_static, psi -> u_o,xi_static,psi,g_static,xi_rain,g_rain,v_circ,d1,g_circ: one ray seen by the
/// static observer, by rain and from the circular orbit; psi from the orbital velocity round the inward axis.
/// No table has a part in it.
std::vector<double> gshift(const RaySource &rays, std::span<const double> inputs);

} // namespace blackhole::ray_columns
