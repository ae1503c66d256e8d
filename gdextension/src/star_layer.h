// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/rid.hpp>

#include "core/catalogue/star.h"
#include "core/culling/buffer_plan.h"
#include "core/culling/star_groups.h"
#include "src/sky_settings.h"

/// Draws a catalogue: per order of images and group of stars one MultiMesh, of which the brightest stars are
/// drawn, as many as can be seen. Those of the second and further images hold hardly more than that; where
/// most of a group is seen, they are the one of the first images. Owns what it makes on the RenderingServer.
class StarLayer {
public:
	static constexpr int kMaxOrders = 4;

	StarLayer() = default;
	StarLayer(const StarLayer &) = delete;
	StarLayer &operator=(const StarLayer &) = delete;
	~StarLayer() { clear(); }

	/// Groups the stars, packs them and uploads them, 48 bytes each.
	void build(const blackhole::StarTable &table);
	void clear();

	/// Puts the layer into a world (an invalid RID takes it out).
	void set_scenario(const godot::RID &scenario);
	void set_shown(bool shown);
	void set_textures(const godot::RID &inverse_table, const godot::RID &planck_table);
	void apply(const SkySettings &settings);

	/// While lensing: the faintest rank, in this group, of which this order's image can be seen. While eyes
	/// are moving, it will soon be another.
	void set_faintest(int order, std::size_t group, double rank, bool moving);
	const std::vector<blackhole::StarGroup> &star_groups() const { return groups; }
	/// V magnitude of the faintest star that may be drawn.
	double faintest() const { return std::min(faintest_magnitude, current.magnitude_limit); }

	/// Bytes of graphics memory that the stars of all orders take.
	int64_t buffer_bytes() const;

	/// No star's sprite reaches farther from its centre, pixels.
	static double largest_reach(const SkySettings &settings);

	/// Peak luminance below which images of this order are not drawn. The many higher images that alone would
	/// not change an 8-bit picture are not worth their cost: there the limit is one step of such a
	/// picture.
	static double faint_limit(const SkySettings &settings, int order);

private:
	static constexpr float kEveryRank = std::numeric_limits<float>::infinity();

	/// A group's images of one order.
	struct Images {
		godot::RID multimesh;
		godot::RID instance;
		int reserved = 0;     ///< stars that are to be drawn
		int drawn = 0;        ///< stars that the MultiMesh is set to draw
		bool borrows = false; ///< draws the MultiMesh of the first images instead, with all stars
		bool visible = false;
	};
	/// The number of stars that are drawn does, and is not much too large, for faintest ranks from here to
	/// below there. At first for none.
	struct Enough {
		float from = kEveryRank;
		float to = 0.0F;
		bool loose = false; ///< chosen for a moving eye
	};
	struct Cell {
		godot::PackedFloat32Array rows; ///< the stars, as buffers hold them
		std::array<Images, kMaxOrders> images;
	};

	void ensure_materials();
	void arrange(bool other_sprite);
	void make_images(std::size_t group, int order);
	int count_to(std::size_t group, double rank) const;
	void draw(std::size_t group, int order, double rank, bool moving);
	void hold(std::size_t group, int order);
	void fill(std::size_t group, int order, std::size_t stars);
	static void set_drawn(Images &images, int count);
	void show(Images &images, int order);
	int orders_drawn() const { return current.lensing ? current.image_orders : 1; }
	std::size_t shader_place() const;
	godot::RID shader();
	godot::RID sprite_in_use() const { return current.shaders == SkyShaders::kMap ? map_sprite : sprite; }
	void set_point_spread(const godot::RID &material);

	/// In the order of their names in star_layer.cpp; most are loaded when they are needed.
	std::array<godot::Ref<godot::Shader>, 12> shaders;
	godot::Ref<godot::ImageTexture> profile; ///< of the model and glare below; null for a Gaussian
	blackhole::PointSpread profile_model = blackhole::PointSpread::kGaussian;
	double profile_glare = 0.0;
	std::array<godot::RID, kMaxOrders> materials;
	godot::RID sprite;
	godot::RID map_sprite;
	godot::RID scenario;
	std::vector<Cell> cells;
	/// Of all groups, asked before each frame: apart, so that this is quickly gone through.
	std::array<std::vector<Enough>, kMaxOrders> enough_of_order;
	std::vector<blackhole::StarGroup> groups;
	blackhole::BufferPlan plan; ///< of the second and further images, group after group
	double faintest_magnitude = 0.0;
	SkySettings current;
	bool layer_shown = true;
	bool dressed = false;  ///< the materials have what the current settings say
	bool arranged = false; ///< the groups have what the current settings ask for
};
