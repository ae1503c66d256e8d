// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/culling/image_bound.h"
#include "core/tables/lensing_tables.h"
#include "src/eye_tracker.h"
#include "src/sky_settings.h"
#include "src/star_layer.h"

/// Lets a layer draw, of each order of images and each group of stars, only those that at least one of the
/// eyes can see. Lensed skies only. While eyes move slowly the choice is made with a reserve for where they
/// will be, and each frame renews a part of it: a frame's work is a fraction of the whole.
class StarChoice {
public:
	/// The next update() chooses all anew: stars or settings are others.
	void reset();
	/// To be called before each frame is drawn. Does nothing while no eye moves.
	void update(StarLayer &layer, const SkySettings &settings, const std::vector<WatchingEye> &eyes,
			const blackhole::LensingTables &tables);

private:
	/// How far eyes may go before a choice no longer holds.
	struct Reserve {
		double turn = 0.0; ///< round the hole, radians
		double aim = 0.0;  ///< of the angle between viewing axis and hole, radians

		bool operator==(const Reserve &) const = default;
	};
	/// One eye's view of one order of images.
	struct View {
		blackhole::ImageBound bound;
		double limit = 0.0; ///< faintest magnitude that this eye sees without lensing
		double slack = 0.0; ///< rad
	};
	/// For which eyes something holds.
	struct Ground {
		std::vector<WatchingEye> eyes;
		Reserve reserve;
	};
	struct Views {
		std::vector<View> of_eyes;
		Ground ground;
	};
	/// A part of an order's groups.
	struct Part {
		bool chosen = false;
		Ground ground;
	};
	static constexpr std::size_t kMostParts = 10; ///< that all orders' groups are renewed in

	static View view_of(const WatchingEye &eye, int order, const SkySettings &settings,
			const blackhole::LensingTables &tables, const Reserve &reserve);
	static bool holds(const Part &part, const std::vector<WatchingEye> &eyes, const SkySettings &settings);
	Reserve reserve_for(const std::vector<WatchingEye> &eyes, const SkySettings &settings) const;
	void look(int order, const SkySettings &settings, const std::vector<WatchingEye> &eyes,
			const blackhole::LensingTables &tables, const Reserve &reserve);
	void choose(std::size_t part, StarLayer &layer, const SkySettings &settings);
	static std::size_t parts_per_order(const SkySettings &settings);

	std::array<Views, StarLayer::kMaxOrders> views;
	std::array<Part, kMostParts> parts;
	std::vector<WatchingEye> last_eyes;
	std::size_t next_part = 0;
};
