// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/variant/rid.hpp>

#include "core/catalogue/star.h"
#include "core/culling/star_groups.h"
#include "src/sky_settings.h"

/// Draws a catalogue: one MultiMesh per star group, one instance of it per image order. Owns what it makes on
/// the RenderingServer.
class StarLayer {
public:
	static constexpr int kMaxOrders = 4;

	StarLayer() = default;
	StarLayer(const StarLayer &) = delete;
	StarLayer &operator=(const StarLayer &) = delete;
	~StarLayer() { clear(); }

	/// Uploads the stars (48 bytes each) and groups them.
	void build(const blackhole::StarTable &table);
	void clear();

	/// Puts the layer into a world (an invalid RID takes it out).
	void set_scenario(const godot::RID &scenario);
	void set_shown(bool shown);
	void set_textures(const godot::RID &inverse_table, const godot::RID &planck_table);
	void apply(const SkySettings &settings);

	/// Draws, per order, only the groups of which an image can be seen. shown[order * group_count() + group].
	void set_group_visibility(int order, std::size_t group, bool shown);
	const std::vector<blackhole::StarGroup> &star_groups() const { return groups; }

private:
	struct Cell {
		godot::RID multimesh;
		std::array<godot::RID, kMaxOrders> instances;
		std::array<bool, kMaxOrders> wanted = {true, true, true, true};
		std::array<bool, kMaxOrders> visible = {false, false, false, false};
		std::vector<float> magnitudes;
		int drawn = -1;
	};

	void ensure_materials();
	void show(Cell &cell, int order);

	godot::Ref<godot::Shader> lensed_shader;
	godot::Ref<godot::Shader> flat_shader;
	std::array<godot::RID, kMaxOrders> materials;
	godot::RID sprite;
	godot::RID scenario;
	std::vector<Cell> cells;
	std::vector<blackhole::StarGroup> groups;
	SkySettings current;
	bool layer_shown = true;
};
