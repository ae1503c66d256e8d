// SPDX-License-Identifier: MIT
#include "src/profile_texture.h"

#include "core/photometry/point_spread_table.h"
#include "src/float_texture.h"

godot::Ref<godot::ImageTexture> make_profile_texture(blackhole::PointSpread model, double glare) {
	using Table = blackhole::PointSpreadTable;
	return make_float_texture(Table(model, glare).texels(), static_cast<int>(Table::kColumns),
			static_cast<int>(Table::kBlocks * (Table::kRows - 1)));
}
