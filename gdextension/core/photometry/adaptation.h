// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// The limits of an automatic exposure, in EV.
struct ExposureLimits {
	double least = -10.0;
	double most = 6.0;
};

/// Luminance to which an automatic exposure brings a picture's mean (LightMeter): that of the demo's first
/// view, which so is shown as with a manual exposure of 0 EV.
inline constexpr double kKeyLuminance = 0.004;

/// The exposure [EV] that shows a picture of mean luminance p_luminance (at 0 EV) at the key, within limits.
/// Black asks for the most.
double wanted_exposure(double p_luminance, const ExposureLimits &p_limits);

/// An exposure that follows what is wanted as eyes do: quickly into the light, slowly into the dark. Both are
/// exponential approaches and exact for any length of a step, so the frame rate makes no difference.
///
/// The order is that of the eye, the times are a film's. To light an eye adapts in seconds, to the dark its
/// cones in some ten minutes and its rods in half an hour (Hecht, Haig and Chase 1937); nobody would wait.
class Adaptation {
public:
	static constexpr double kLightSeconds = 0.4; ///< time constant of getting darker pictures
	static constexpr double kDarkSeconds = 2.5;  ///< of getting brighter ones

	/// Moves on by p_seconds at p_speed times these paces; 0: at once.
	void step(double p_wanted_ev, double p_seconds, double p_speed);
	void settle(double p_ev) { m_ev = p_ev; }
	double ev() const { return m_ev; }

private:
	double m_ev = 0.0;
};

} // namespace blackhole
