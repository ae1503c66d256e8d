// SPDX-License-Identifier: MIT
#include "src/star_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include "core/photometry/planck_table.h"
#include "core/photometry/radiometry.h"

using namespace godot;

namespace {

constexpr int kFloatsPerStar = 12;
constexpr int kMapCopies = 3;         // the sprite, across a seam, across a pole
constexpr int kRenderPriority = -100; // behind everything else that is transparent, before the background
constexpr float kEverywhere = 1e6F;
constexpr float kEveryRank = std::numeric_limits<float>::infinity();
constexpr double kHigherOrderFaintness = 6.0; // 6 x 5e-5: one step of an 8-bit sRGB picture

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

AABB everywhere() {
	return {Vector3(-kEverywhere, -kEverywhere, -kEverywhere), Vector3(2, 2, 2) * kEverywhere};
}

/// The instance transform that the shader reads (see star_layer.gdshaderinc): three rows of basis and origin.
void pack_star(const blackhole::Star &star, const glm::dvec3 &direction, const blackhole::PlanckTable &planck,
		float *row) {
	const double log_luminance = planck.log2_luminance(star.temperature_k);
	const double radius = blackhole::star_angular_radius(star.v_magnitude, star.temperature_k, planck);
	const float values[kFloatsPerStar] = {std::pow(10.0F, -0.4F * star.v_magnitude),
			static_cast<float>(radius), 0.0F, static_cast<float>(direction.x), star.temperature_k,
			star.v_magnitude, 0.0F, static_cast<float>(direction.y), static_cast<float>(log_luminance), 0.0F,
			0.0F, static_cast<float>(direction.z)};
	std::copy(std::begin(values), std::end(values), row);
}

} // namespace

void StarLayer::ensure_materials() {
	if (sprite.is_valid()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	lensed_shader =
			ResourceLoader::get_singleton()->load("res://addons/blackhole_sky/shaders/stars_lensed.gdshader");
	general_shader = ResourceLoader::get_singleton()->load(
			"res://addons/blackhole_sky/shaders/stars_general.gdshader");
	map_shader =
			ResourceLoader::get_singleton()->load("res://addons/blackhole_sky/shaders/stars_map.gdshader");
	flat_shader =
			ResourceLoader::get_singleton()->load("res://addons/blackhole_sky/shaders/stars_flat.gdshader");
	sprite = make_sprite_mesh(server, 1);
	map_sprite = make_sprite_mesh(server, kMapCopies);
	for (int order = 0; order < kMaxOrders; ++order) {
		const RID material = server->material_create();
		server->material_set_render_priority(material, kRenderPriority + order);
		server->material_set_param(material, "_order", order);
		materials[static_cast<std::size_t>(order)] = material;
	}
}

void StarLayer::build(const blackhole::StarTable &table) {
	clear();
	ensure_materials();
	const blackhole::PlanckTable planck;
	std::vector<glm::dvec3> directions;
	directions.reserve(table.stars.size());
	for (const blackhole::Star &star : table.stars) {
		directions.push_back(blackhole::world_direction(star));
	}
	groups = blackhole::group_stars(table, directions, planck);
	faintest_magnitude = table.stars.empty() ? 0.0 : table.stars.back().v_magnitude;
	cells.resize(groups.size());
	for (std::size_t g = 0; g < groups.size(); ++g) {
		Cell &cell = cells[g];
		const std::vector<uint32_t> &members = groups[g].stars;
		cell.rows.resize(static_cast<int64_t>(members.size()) * kFloatsPerStar);
		float *row = cell.rows.ptrw();
		for (const uint32_t member : members) {
			pack_star(table.stars[member], directions[member], planck, row);
			row += kFloatsPerStar;
		}
	}
	apply(current);
}

void StarLayer::make_images(std::size_t group, int order) {
	Cell &cell = cells[group];
	Images &images = cell.images[static_cast<std::size_t>(order)];
	if (images.multimesh.is_valid()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	images.multimesh = server->multimesh_create();
	server->multimesh_allocate_data(images.multimesh, static_cast<int32_t>(groups[group].stars.size()),
			RenderingServer::MULTIMESH_TRANSFORM_3D);
	server->multimesh_set_mesh(images.multimesh, sprite_in_use());
	server->multimesh_set_custom_aabb(images.multimesh, everywhere());
	server->multimesh_set_buffer(images.multimesh, cell.rows);
	server->multimesh_set_visible_instances(images.multimesh, 0);
	images.instance = server->instance_create();
	server->instance_set_base(images.instance, images.multimesh);
	server->instance_set_custom_aabb(images.instance, everywhere());
	server->instance_set_visible(images.instance, false);
	server->instance_geometry_set_material_override(
			images.instance, materials[static_cast<std::size_t>(order)]);
	server->instance_geometry_set_cast_shadows_setting(
			images.instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
	if (scenario.is_valid()) {
		server->instance_set_scenario(images.instance, scenario);
	}
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

void StarLayer::draw(std::size_t group, int order, double rank) {
	Images &images = cells[group].images[static_cast<std::size_t>(order)];
	const int count = count_to(group, rank);
	const int all = count_to(group, kEveryRank);
	// Some to spare, so that a moving eye seldom changes the number.
	const int spare = 2 + count / 32;
	const int reserved = count == 0 ? 0 : std::min(count + spare, all);
	if (reserved != images.reserved) {
		images.reserved = reserved;
		RenderingServer::get_singleton()->multimesh_set_visible_instances(images.multimesh, reserved);
	}
	const auto rank_of = [&ranks = groups[group].ranks](
								 int at) { return ranks[static_cast<std::size_t>(at)]; };
	images.enough_to = reserved < all ? rank_of(reserved) : kEveryRank;
	images.enough_from = reserved == 0 ? -kEveryRank : rank_of(std::max(reserved - 4 * spare, 0));
	show(images, order);
}

void StarLayer::show(Images &images, int order) {
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

void StarLayer::set_faintest(int order, std::size_t group, double rank) {
	const Images &images = cells[group].images[static_cast<std::size_t>(order)];
	const auto limit = static_cast<float>(rank);
	if (limit < images.enough_from || limit >= images.enough_to) {
		draw(group, order, rank);
	}
}

double StarLayer::faint_limit(const SkySettings &settings, int order) {
	return settings.faint_limit * (order > 0 ? kHigherOrderFaintness : 1.0);
}

RID StarLayer::shader() const {
	switch (current.shaders) {
		case SkyShaders::kRadial:
			return lensed_shader->get_rid();
		case SkyShaders::kGeneral:
			return general_shader->get_rid();
		case SkyShaders::kMap:
			return map_shader->get_rid();
		default:
			return flat_shader->get_rid();
	}
}

void StarLayer::apply(const SkySettings &settings) {
	const bool other_sprite = (settings.shaders == SkyShaders::kMap) != (current.shaders == SkyShaders::kMap);
	current = settings;
	ensure_materials();
	RenderingServer *server = RenderingServer::get_singleton();
	for (int order = 0; order < kMaxOrders; ++order) {
		const RID material = materials[static_cast<std::size_t>(order)];
		server->material_set_shader(material, shader());
		set_sky_uniforms(material, settings);
		server->material_set_param(material, "_exposure", blackhole::kStarGain * settings.exposure);
		server->material_set_param(material, "_psf_sigma", settings.psf_sigma);
		server->material_set_param(material, "_faint_limit", faint_limit(settings, order));
		server->material_set_param(
				material, "_flux_limit", std::pow(10.0, -0.4 * (settings.magnitude_limit + 1e-6)));
	}
	for (std::size_t group = 0; group < cells.size(); ++group) {
		for (int order = 0; order < kMaxOrders; ++order) {
			Images &images = cells[group].images[static_cast<std::size_t>(order)];
			if (order < orders_drawn()) {
				make_images(group, order);
			}
			images.enough_from = kEveryRank; // ask anew: the magnitude limit may be another
			if (!settings.lensing && order == 0) {
				draw(group, order, kEveryRank);
			}
			if (images.instance.is_valid()) {
				if (other_sprite) {
					server->multimesh_set_mesh(images.multimesh, sprite_in_use());
				}
				server->instance_set_layer_mask(images.instance, settings.render_layers);
				show(images, order);
			}
		}
	}
}
