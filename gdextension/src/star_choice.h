// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/tables/lensing_tables.h"
#include "src/eye_tracker.h"
#include "src/sky_settings.h"
#include "src/star_layer.h"

/// Lets the layer draw, of each order of images and each group of stars, only those that at least one of the
/// eyes can see. Lensed skies only.
void choose_stars(StarLayer &layer, const SkySettings &settings, const std::vector<WatchingEye> &eyes,
		const blackhole::LensingTables &tables);
