// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// Second radiation constant h c / k in metre kelvin (exact SI 2019 value, rounded).
inline constexpr double kSecondRadiationConstant = 1.438776877e-2;
/// First radiation constant for radiance 2 h c^2 in W m^2 / sr.
inline constexpr double kFirstRadiationConstant = 1.191042972e-16;
/// Luminous efficacy that ties watts to lumens: 683.002 lm/W for the CIE 1931 tables.
inline constexpr double kLuminousEfficacy = 683.002;

/// The Sun as a star: V magnitude, temperature (K) and angular radius (radians) as seen from one astronomical
/// unit.
inline constexpr double kSolarMagnitude = -26.74;
inline constexpr double kSolarTemperature = 5772.0;
inline constexpr double kSolarAngularRadius = 4.6505e-3;

} // namespace blackhole
