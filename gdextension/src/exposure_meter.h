// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/disk/disk_glow.h"
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
	/// The disks before the sky, with the settings by which they are drawn. `tables` null: none.
	struct DiskSources {
		std::vector<blackhole::GlowingDisk> disks;
		SkySettings settings;
		const blackhole::LensingTables *tables = nullptr;
	};
	/// What there is to be metered, and from where. `tables` null: without a hole.
	struct View {
		const SkySettings &settings;
		const blackhole::LensingTables *tables;
		const WatchingEye &eye;
		const SkyLight::Sources &sources;
		const DiskSources &disks;
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
	/// Light of the disks, and of what is behind them as far as it comes through.
	double before(
			const DiskSources &disks, const glm::dvec3 &place, const glm::dvec3 &direction, double behind);

	SkyLight light;
	std::unique_ptr<blackhole::PlanckTable> planck; ///< of disks
	blackhole::LightMeter meter;
	blackhole::Adaptation adaptation;
	bool metered = false; ///< all directions have been, once
	bool begun = false;
};
