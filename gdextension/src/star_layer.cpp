// SPDX-License-Identifier: MIT
#include "src/star_layer.h"

#include <algorithm>
#include <cmath>

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include "core/culling/star_rows.h"
#include "core/parallel.h"
#include "core/photometry/planck_table.h"
#include "core/photometry/radiometry.h"
#include "src/draw_order.h"
#include "src/glm_adapter.h"
#include "src/profile_texture.h"

using namespace godot;

namespace {

constexpr int kMapCopies = 3;                                      // the sprite, across a seam, across a pole
constexpr float kFaintestRank = std::numeric_limits<float>::max(); // of which one can ask
/// Of images of order 1 and above: 8 x 5e-5 is still within the first step of an 8-bit sRGB picture.
constexpr double kHigherOrderFaintness = 8.0;
/// LARGEST_SPRITE and LARGEST_PROFILE of star_layer.gdshaderinc.
constexpr double kLargestSprite = 5.3;
constexpr double kLargestProfile = 256.0;
constexpr std::size_t kHigherOrders = StarLayer::kMaxOrders - 1;
/// Rows that the second and further images should hold together, as a part of the stars: 14.4 bytes a star.
/// Catalogues whose rows are fewer than these all in all (12 MB) need not be thrifty, so that their buffers
/// seldom change.
constexpr double kHigherShare = 0.3;
constexpr double kFreelyHeldRows = 250000.0;
/// From which part of a group on higher images draw all of it, and below which one no longer.
struct BorrowLimits {
	double from;
	double down_to;
};

/// Drawing more than is seen costs time, buffers of their own cost memory: that is saved when it runs short.
BorrowLimits borrow_limits(double pressure) {
	BorrowLimits limits{0.97, 0.9};
	if (pressure >= 0.65) {
		limits.from = 0.3;
	} else if (pressure >= 0.45) {
		limits.from = 0.6;
	}
	// Lower, so that cells do not go to and fro as they themselves change the pressure.
	if (pressure >= 0.45) {
		limits.down_to = 0.2;
	} else if (pressure >= 0.3) {
		limits.down_to = 0.5;
	}
	return limits;
}

/// By SkyShaders, then for stars with a profile, then both for a sky through which the room shows.
constexpr std::array<const char *, 12> kShaderNames = {"stars_flat", "stars_lensed", "stars_general",
		"stars_map", "stars_flat_profile", "stars_lensed_profile", "stars_general_profile",
		"stars_map_profile", "stars_lensed_clear", "stars_general_clear", "stars_lensed_profile_clear",
		"stars_general_profile_clear"};
constexpr std::size_t kFirstProfile = 4;
constexpr std::size_t kFirstClear = 8;

Ref<Shader> load_shader(std::size_t place) {
	const String path = String("res://addons/blackhole_sky/shaders/") + kShaderNames.at(place) + ".gdshader";
	return ResourceLoader::get_singleton()->load(path);
}

/// Triangles whose inscribed circle is the unit circle: three vertices a star rather than a quad's four.
/// Their z is their number, from which the shader of maps knows which of a sprite's copies each is.
RID make_sprite_mesh(RenderingServer *server, int copies) {
	PackedVector3Array vertices;
	for (int copy = 0; copy < copies; ++copy) {
		const auto z = static_cast<real_t>(copy);
		vertices.push_back(Vector3(0, 2, z));
		vertices.push_back(Vector3(-1.7320508F, -1, z));
		vertices.push_back(Vector3(1.7320508F, -1, z));
	}
	Array arrays;
	arrays.resize(RenderingServer::ARRAY_MAX);
	arrays[RenderingServer::ARRAY_VERTEX] = vertices;
	RID mesh = server->mesh_create();
	server->mesh_add_surface_from_arrays(mesh, RenderingServer::PRIMITIVE_TRIANGLES, arrays);
	return mesh;
}

std::size_t plan_place(std::size_t group, int order) {
	return group * kHigherOrders + static_cast<std::size_t>(order) - 1;
}

/// The first stars of a cell.
PackedFloat32Array first_rows(const PackedFloat32Array &rows, std::size_t stars) {
	const auto size = static_cast<int64_t>(stars * blackhole::kFloatsPerStar);
	if (size == rows.size()) {
		return rows; // shared, not copied
	}
	PackedFloat32Array part;
	part.resize(size);
	std::copy(rows.ptr(), rows.ptr() + size, part.ptrw());
	return part;
}

} // namespace

void StarLayer::ensure_materials() {
	if (sprite.is_valid()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	for (std::size_t i = 0; i < kFirstProfile; ++i) {
		shaders[i] = load_shader(i);
	}
	dressed = false;
	sprite = make_sprite_mesh(server, 1);
	map_sprite = make_sprite_mesh(server, kMapCopies);
	for (int order = 0; order < kMaxOrders; ++order) {
		const RID material = server->material_create();
		server->material_set_render_priority(material, kStarPriority + order);
		server->material_set_param(material, "_order", order);
		materials[static_cast<std::size_t>(order)] = material;
	}
}

void StarLayer::build(const blackhole::StarTable &table) {
	clear();
	ensure_materials();
	const blackhole::PlanckTable planck;
	const std::vector<glm::dvec3> directions = blackhole::star_directions(table);
	groups = blackhole::group_stars(table, directions, planck);
	faintest_magnitude = table.stars.empty() ? 0.0 : table.stars.back().v_magnitude;
	cells.resize(groups.size());
	for (std::vector<Enough> &enough : enough_of_order) {
		enough.assign(groups.size(), Enough());
	}
	std::vector<float *> rows;
	std::vector<std::size_t> lengths;
	for (std::size_t g = 0; g < groups.size(); ++g) {
		const std::size_t stars = groups[g].stars.size();
		cells[g].rows.resize(static_cast<int64_t>(stars * blackhole::kFloatsPerStar));
		rows.push_back(cells[g].rows.ptrw());
		lengths.insert(lengths.end(), kHigherOrders, stars);
	}
	blackhole::parallel_for(groups.size(), 8, [&](std::size_t first, std::size_t end) {
		for (std::size_t g = first; g < end; ++g) {
			blackhole::pack_rows(table, directions, groups[g], planck, rows[g]);
		}
	});
	const auto count = static_cast<double>(table.stars.size());
	const double most = std::max(kHigherShare * count, kFreelyHeldRows - count);
	plan = blackhole::BufferPlan(lengths, static_cast<std::size_t>(most));
	arranged = false;
	apply(current);
}

void StarLayer::make_images(std::size_t group, int order) {
	Images &images = cells[group].images[static_cast<std::size_t>(order)];
	if (images.multimesh.is_valid()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	images.multimesh = server->multimesh_create();
	server->multimesh_set_mesh(images.multimesh, sprite_in_use());
	server->multimesh_set_custom_aabb(images.multimesh, everywhere());
	if (order == 0) {
		fill(group, order, groups[group].stars.size());
	}
	images.instance = server->instance_create();
	server->instance_set_base(images.instance, images.multimesh);
	server->instance_set_custom_aabb(images.instance, everywhere());
	// One order of drawing, whatever buffers have been made: sums in 8 bits depend on it.
	server->instance_set_pivot_data(images.instance, static_cast<float>(group), true);
	server->instance_set_visible(images.instance, false);
	server->instance_set_layer_mask(images.instance, current.render_layers);
	server->instance_geometry_set_material_override(
			images.instance, materials[static_cast<std::size_t>(order)]);
	server->instance_geometry_set_cast_shadows_setting(
			images.instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
	if (scenario.is_valid()) {
		server->instance_set_scenario(images.instance, scenario);
	}
}

/// Makes a buffer of a group's first stars.
void StarLayer::fill(std::size_t group, int order, std::size_t stars) {
	Cell &cell = cells[group];
	Images &images = cell.images[static_cast<std::size_t>(order)];
	RenderingServer *server = RenderingServer::get_singleton();
	server->multimesh_allocate_data(
			images.multimesh, static_cast<int32_t>(stars), RenderingServer::MULTIMESH_TRANSFORM_3D);
	server->multimesh_set_buffer(images.multimesh, first_rows(cell.rows, stars));
	// The engine takes a number beyond the stars down to theirs when it makes a buffer.
	images.drawn = std::min(images.drawn, static_cast<int>(stars));
	server->multimesh_set_visible_instances(images.multimesh, images.drawn);
}

void StarLayer::set_drawn(Images &images, int count) {
	if (count != images.drawn) {
		images.drawn = count;
		RenderingServer::get_singleton()->multimesh_set_visible_instances(images.multimesh, count);
	}
}

/// Gives the images of an order as many stars to draw as are reserved.
void StarLayer::hold(std::size_t group, int order) {
	Cell &cell = cells[group];
	Images &first = cell.images.front();
	Images &images = cell.images[static_cast<std::size_t>(order)];
	const int all = count_to(group, kEveryRank);
	if (images.reserved > 0) {
		make_images(group, order);
	}
	if (order > 0) {
		const bool borrows = all > 0 && images.reserved == all;
		if (borrows != images.borrows) {
			images.borrows = borrows;
			RenderingServer::get_singleton()->instance_set_base(
					images.instance, borrows ? first.multimesh : images.multimesh);
		}
		const auto needed = static_cast<std::size_t>(borrows ? 0 : images.reserved);
		for (const std::size_t place : plan.need(plan_place(group, order), needed)) {
			fill(place / kHigherOrders, static_cast<int>(place % kHigherOrders) + 1, plan.holds(place));
		}
		if (!borrows && images.multimesh.is_valid()) {
			set_drawn(images, images.reserved);
		}
	}
	const bool lends = std::any_of(
			cell.images.begin(), cell.images.end(), [](const Images &other) { return other.borrows; });
	if (first.multimesh.is_valid()) {
		set_drawn(first, lends ? all : first.reserved);
	}
}

int64_t StarLayer::buffer_bytes() const {
	std::size_t stars = plan.total();
	for (std::size_t g = 0; g < cells.size(); ++g) {
		stars += cells[g].images.front().multimesh.is_valid() ? groups[g].stars.size() : 0;
	}
	return static_cast<int64_t>(stars * blackhole::kFloatsPerStar * sizeof(float));
}

void StarLayer::clear() {
	RenderingServer *server = RenderingServer::get_singleton();
	if (server == nullptr) {
		return;
	}
	for (const Cell &cell : cells) {
		for (const Images &images : cell.images) {
			if (images.multimesh.is_valid()) {
				server->free_rid(images.instance);
				server->free_rid(images.multimesh);
			}
		}
	}
	cells.clear();
	groups.clear();
	plan = blackhole::BufferPlan();
	if (sprite.is_valid()) {
		server->free_rid(sprite);
		server->free_rid(map_sprite);
		sprite = map_sprite = RID();
		for (RID &material : materials) {
			server->free_rid(material);
			material = RID();
		}
	}
}

void StarLayer::set_scenario(const RID &p_scenario) {
	scenario = p_scenario;
	RenderingServer *server = RenderingServer::get_singleton();
	for (const Cell &cell : cells) {
		for (const Images &images : cell.images) {
			if (images.instance.is_valid()) {
				server->instance_set_scenario(images.instance, scenario);
			}
		}
	}
}

void StarLayer::set_textures(const RID &inverse_table, const RID &planck_table) {
	ensure_materials();
	RenderingServer *server = RenderingServer::get_singleton();
	for (const RID &material : materials) {
		server->material_set_param(material, "_inverse_table", inverse_table);
		server->material_set_param(material, "_planck_table", planck_table);
	}
}

int StarLayer::count_to(std::size_t group, double rank) const {
	// Ranks lie below magnitudes: no star within the magnitude limit is left out, and the shader skips the
	// others.
	const std::vector<float> &ranks = groups[group].ranks;
	const auto limit = static_cast<float>(std::min(rank, current.magnitude_limit));
	if (ranks.empty() || limit >= ranks.back()) {
		return static_cast<int>(ranks.size());
	}
	return static_cast<int>(std::upper_bound(ranks.begin(), ranks.end(), limit) - ranks.begin());
}

void StarLayer::draw(std::size_t group, int order, double rank, bool moving) {
	Images &images = cells[group].images[static_cast<std::size_t>(order)];
	const int count = count_to(group, rank);
	const int all = count_to(group, kEveryRank);
	// Some to spare: changing the number takes time too. Eyes at rest have it exact.
	const int spare = moving ? 8 + count / 8 : 2 + count / 32;
	int reserved = count == 0 ? 0 : std::min(count + spare, all);
	int lowest = count - (moving ? 2 : 3) * spare;
	const BorrowLimits limits = borrow_limits(plan.pressure());
	if (order > 0 && count > 0 && reserved >= (images.borrows ? limits.down_to : limits.from) * all) {
		reserved = all;
		lowest = static_cast<int>(limits.down_to * all) - spare;
	}
	if (reserved != images.reserved) {
		images.reserved = reserved;
		hold(group, order);
	}
	const auto rank_of = [&ranks = groups[group].ranks](
								 int at) { return ranks[static_cast<std::size_t>(at)]; };
	Enough &enough = enough_of_order[static_cast<std::size_t>(order)][group];
	enough.loose = moving;
	enough.to = reserved < all ? rank_of(reserved) : kEveryRank;
	enough.from = reserved == 0 ? -kEveryRank : rank_of(std::max(lowest, 0));
	show(images, order);
}

void StarLayer::show(Images &images, int order) {
	if (!images.instance.is_valid()) {
		return;
	}
	const bool visible = layer_shown && images.reserved > 0 && order < orders_drawn();
	if (visible != images.visible) {
		images.visible = visible;
		RenderingServer::get_singleton()->instance_set_visible(images.instance, visible);
	}
}

void StarLayer::set_shown(bool shown) {
	layer_shown = shown;
	for (Cell &cell : cells) {
		for (int order = 0; order < kMaxOrders; ++order) {
			show(cell.images[static_cast<std::size_t>(order)], order);
		}
	}
}

void StarLayer::set_faintest(int order, std::size_t group, double rank, bool moving) {
	const Enough &enough = enough_of_order[static_cast<std::size_t>(order)][group];
	const auto limit = static_cast<float>(std::min(rank, double{kFaintestRank}));
	const bool loose = enough.loose && !moving;
	if (loose || limit < enough.from || limit >= enough.to) {
		draw(group, order, rank, moving);
	}
}

double StarLayer::largest_reach(const SkySettings &settings) {
	const bool gaussian = settings.psf_model == blackhole::PointSpread::kGaussian;
	return gaussian ? kLargestSprite * settings.psf_sigma : kLargestProfile;
}

double StarLayer::faint_limit(const SkySettings &settings, int order) {
	return settings.faint_limit * (order > 0 ? kHigherOrderFaintness : 1.0);
}

std::size_t StarLayer::shader_place() const {
	const bool with_profile = current.psf_model != blackhole::PointSpread::kGaussian;
	if (is_clear(current)) {
		return kFirstClear + (with_profile ? 2 : 0) + (current.shaders == SkyShaders::kRadial ? 0 : 1);
	}
	return static_cast<std::size_t>(current.shaders) + (with_profile ? kFirstProfile : 0);
}

RID StarLayer::shader() {
	const std::size_t place = shader_place();
	if (shaders[place].is_null()) {
		shaders[place] = load_shader(place);
	}
	return shaders[place]->get_rid();
}

void StarLayer::set_point_spread(const RID &material) {
	RenderingServer *server = RenderingServer::get_singleton();
	server->material_set_param(material, "_psf_sigma", current.psf_sigma);
	const blackhole::PointSpread model = current.psf_model;
	if (model == blackhole::PointSpread::kGaussian) {
		return;
	}
	if (profile.is_null() || model != profile_model || current.glare != profile_glare) {
		profile = make_profile_texture(model, current.glare);
		profile_model = model;
		profile_glare = current.glare;
	}
	const bool by_colour = model == blackhole::PointSpread::kAiry;
	const glm::dvec3 angle =
			by_colour ? blackhole::airy_angles(current.aperture) : glm::dvec3(blackhole::kEyeAngle);
	server->material_set_param(material, "_profile_table", profile->get_rid());
	server->material_set_param(material, "_profile_angle", to_godot(angle));
	server->material_set_param(material, "_profile_by_colour", by_colour);
}

void StarLayer::apply(const SkySettings &settings) {
	const bool other_sprite = (settings.shaders == SkyShaders::kMap) != (current.shaders == SkyShaders::kMap);
	const bool arranged_alike = !other_sprite && arranged && settings.lensing == current.lensing &&
			settings.image_orders == current.image_orders &&
			settings.magnitude_limit == current.magnitude_limit &&
			settings.render_layers == current.render_layers;
	ensure_materials();
	const bool uniform = dressed && has_equal_uniforms(settings, current);
	const bool equal_stars = dressed && settings.shaders == current.shaders &&
			is_clear(settings) == is_clear(current) && settings.psf_model == current.psf_model &&
			settings.psf_sigma == current.psf_sigma && settings.aperture == current.aperture &&
			settings.glare == current.glare && settings.faint_limit == current.faint_limit &&
			settings.magnitude_limit == current.magnitude_limit;
	current = settings;
	RenderingServer *server = RenderingServer::get_singleton();
	for (int order = 0; order < kMaxOrders; ++order) {
		const RID material = materials[static_cast<std::size_t>(order)];
		if (!equal_stars) {
			server->material_set_shader(material, shader());
			set_point_spread(material);
			server->material_set_param(material, "_faint_limit", faint_limit(settings, order));
			server->material_set_param(
					material, "_flux_limit", std::pow(10.0, -0.4 * (settings.magnitude_limit + 1e-6)));
		}
		if (!uniform) {
			set_sky_uniforms(material, settings);
		}
		server->material_set_param(material, "_exposure", blackhole::kStarGain * settings.exposure);
	}
	dressed = true;
	// Flights and rides change other settings in each frame.
	if (!arranged_alike) {
		arrange(other_sprite);
	}
}

/// Gives every group the images that the settings ask for.
void StarLayer::arrange(bool other_sprite) {
	arranged = true;
	RenderingServer *server = RenderingServer::get_singleton();
	for (std::size_t group = 0; group < cells.size(); ++group) {
		for (int order = 0; order < kMaxOrders; ++order) {
			Images &images = cells[group].images[static_cast<std::size_t>(order)];
			if (order == 0) {
				make_images(group, order);
			} else if (order >= orders_drawn() && images.reserved > 0) {
				images.reserved = 0;
				hold(group, order);
			}
			enough_of_order[static_cast<std::size_t>(order)][group] = Enough();
			if (!current.lensing && order == 0) {
				draw(group, order, kEveryRank, false);
			}
			if (images.instance.is_valid()) {
				if (other_sprite) {
					server->multimesh_set_mesh(images.multimesh, sprite_in_use());
				}
				server->instance_set_layer_mask(images.instance, current.render_layers);
				show(images, order);
			}
		}
	}
}
