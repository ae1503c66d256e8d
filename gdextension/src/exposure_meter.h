// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/photometry/adaptation.h"
#include "core/photometry/light_meter.h"
#include "core/tables/lensing_tables.h"
#include "src/eye_tracker.h"
#include "src/sky_light.h"
#include "src/sky_settings.h"

/// The automatic exposure of a sky: meters what an eye sees, by rays traced on the processor, and adapts to
/// it.
class ExposureMeter {
public:
	/// What there is to be metered, and from where. `tables` null: without a hole.
	struct View {
		const SkySettings &settings;
		const blackhole::LensingTables *tables;
		const WatchingEye &eye;
		const SkyLight::Sources &sources;
	};

	blackhole::ExposureLimits limits;
	double speed = 1.0; ///< of adaptation, times the usual paces; 0: at once

	/// The catalogue holds other stars than before.
	void forget_stars() { light.forget_stars(); }
	/// Adaptation begins anew: at the next view at once.
	void begin() { begun = false; }
	/// Adaptation begins from a known exposure [EV].
	void begin_from(double ev);

	/// Meters as many directions as a frame of so many seconds should, or all, and adapts for that time.
	void step(const View &view, double seconds, bool all = false);
	/// Meters all directions, and is adapted.
	void settle(const View &view);
	/// The exposure, in EV.
	double ev() const { return adaptation.ev(); }

private:
	void measure(const View &view, std::size_t directions);

	SkyLight light;
	blackhole::LightMeter meter;
	blackhole::Adaptation adaptation;
	bool metered = false; ///< all directions have been, once
	bool begun = false;
};
