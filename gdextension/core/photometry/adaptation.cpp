// SPDX-License-Identifier: MIT
#include "core/photometry/adaptation.h"

#include <algorithm>
#include <cmath>

namespace blackhole {

double wanted_exposure(double p_luminance, const ExposureLimits &p_limits) {
	if (!(p_luminance > 0.0)) {
		return p_limits.most;
	}
	return std::clamp(std::log2(kKeyLuminance / p_luminance), p_limits.least, p_limits.most);
}

void Adaptation::step(double p_wanted_ev, double p_seconds, double p_speed) {
	if (!(p_speed > 0.0)) {
		settle(p_wanted_ev);
		return;
	}
	const double constant = p_wanted_ev < m_ev ? kLightSeconds : kDarkSeconds;
	const double way = -std::expm1(-std::max(p_seconds, 0.0) * p_speed / constant);
	m_ev += way * (p_wanted_ev - m_ev);
}

} // namespace blackhole
