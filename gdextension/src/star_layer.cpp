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

#include "core/photometry/planck_table.h"
#include "core/photometry/radiometry.h"

using namespace godot;

namespace {

constexpr int kFloatsPerStar = 12;
constexpr int kRenderPriority = -100; // behind everything else that is transparent, before the background
constexpr float kEverywhere = 1e6F;

/// A triangle whose inscribed circle is the unit circle: three vertices a star rather than a quad's four.
RID make_sprite_mesh(RenderingServer *server) {
	PackedVector3Array vertices;
	vertices.push_back(Vector3(0, 2, 0));
	vertices.push_back(Vector3(-1.7320508F, -1, 0));
	vertices.push_back(Vector3(1.7320508F, -1, 0));
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
void pack_star(const blackhole::Star &star, const blackhole::PlanckTable &planck, float *row) {
	const glm::dvec3 direction = blackhole::world_direction(star);
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
	flat_shader =
			ResourceLoader::get_singleton()->load("res://addons/blackhole_sky/shaders/stars_flat.gdshader");
	sprite = make_sprite_mesh(server);
	for (int order = 0; order < kMaxOrders; ++order) {
		const RID material = server->material_create();
		server->material_set_render_priority(material, kRenderPriority);
		server->material_set_param(material, "_order", order);
		materials[static_cast<std::size_t>(order)] = material;
	}
}

void StarLayer::build(const blackhole::StarTable &table) {
	clear();
	ensure_materials();
	RenderingServer *server = RenderingServer::get_singleton();
	const blackhole::PlanckTable planck;
	groups = blackhole::group_stars(table);
	cells.resize(groups.size());
	for (std::size_t g = 0; g < groups.size(); ++g) {
		Cell &cell = cells[g];
		const std::vector<uint32_t> &members = groups[g].stars;
		PackedFloat32Array buffer;
		buffer.resize(static_cast<int64_t>(members.size()) * kFloatsPerStar);
		float *row = buffer.ptrw();
		cell.magnitudes.reserve(members.size());
		for (const uint32_t member : members) {
			pack_star(table.stars[member], planck, row);
			cell.magnitudes.push_back(table.stars[member].v_magnitude);
			row += kFloatsPerStar;
		}
		cell.multimesh = server->multimesh_create();
		server->multimesh_allocate_data(cell.multimesh, static_cast<int32_t>(members.size()),
				RenderingServer::MULTIMESH_TRANSFORM_3D);
		server->multimesh_set_mesh(cell.multimesh, sprite);
		server->multimesh_set_custom_aabb(cell.multimesh, everywhere());
		server->multimesh_set_buffer(cell.multimesh, buffer);
		for (int order = 0; order < kMaxOrders; ++order) {
			const RID instance = server->instance_create();
			server->instance_set_base(instance, cell.multimesh);
			server->instance_set_custom_aabb(instance, everywhere());
			server->instance_set_visible(instance, false);
			server->instance_geometry_set_material_override(
					instance, materials[static_cast<std::size_t>(order)]);
			server->instance_geometry_set_cast_shadows_setting(
					instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
			if (scenario.is_valid()) {
				server->instance_set_scenario(instance, scenario);
			}
			cell.instances[static_cast<std::size_t>(order)] = instance;
		}
	}
	apply(current);
}

void StarLayer::clear() {
	RenderingServer *server = RenderingServer::get_singleton();
	if (server == nullptr) {
		return;
	}
	for (const Cell &cell : cells) {
		for (const RID &instance : cell.instances) {
			server->free_rid(instance);
		}
		server->free_rid(cell.multimesh);
	}
	cells.clear();
	groups.clear();
	if (sprite.is_valid()) {
		server->free_rid(sprite);
		sprite = RID();
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
		for (const RID &instance : cell.instances) {
			server->instance_set_scenario(instance, scenario);
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

void StarLayer::show(Cell &cell, int order) {
	const auto o = static_cast<std::size_t>(order);
	const int orders = current.lensing ? current.image_orders : 1;
	const bool visible =
			layer_shown && cell.drawn > 0 && order < orders && (cell.wanted[o] || !current.lensing);
	if (visible != cell.visible[o]) {
		cell.visible[o] = visible;
		RenderingServer::get_singleton()->instance_set_visible(cell.instances[o], visible);
	}
}

void StarLayer::set_shown(bool shown) {
	layer_shown = shown;
	for (Cell &cell : cells) {
		for (int order = 0; order < kMaxOrders; ++order) {
			show(cell, order);
		}
	}
}

void StarLayer::set_group_visibility(int order, std::size_t group, bool shown) {
	Cell &cell = cells[group];
	cell.wanted[static_cast<std::size_t>(order)] = shown;
	show(cell, order);
}

void StarLayer::apply(const SkySettings &settings) {
	current = settings;
	ensure_materials();
	RenderingServer *server = RenderingServer::get_singleton();
	const RID shader = settings.lensing ? lensed_shader->get_rid() : flat_shader->get_rid();
	for (const RID &material : materials) {
		server->material_set_shader(material, shader);
		server->material_set_param(material, "_hole_position", settings.hole_position);
		server->material_set_param(material, "_inverse_radius", settings.inverse_radius);
		server->material_set_param(material, "_observer_motion", settings.observer_motion);
		server->material_set_param(material, "_sky_to_world", settings.sky_to_world);
		server->material_set_param(material, "_exposure", blackhole::kStarGain * settings.exposure);
		server->material_set_param(material, "_psf_sigma", settings.psf_sigma);
		server->material_set_param(material, "_faint_limit", settings.faint_limit);
		server->material_set_param(
				material, "_flux_limit", std::pow(10.0, -0.4 * (settings.magnitude_limit + 1e-6)));
	}
	for (Cell &cell : cells) {
		const auto end = std::upper_bound(
				cell.magnitudes.begin(), cell.magnitudes.end(), static_cast<float>(settings.magnitude_limit));
		const int drawn = static_cast<int>(end - cell.magnitudes.begin());
		if (drawn != cell.drawn) {
			cell.drawn = drawn;
			server->multimesh_set_visible_instances(cell.multimesh, drawn);
		}
		for (int order = 0; order < kMaxOrders; ++order) {
			const auto o = static_cast<std::size_t>(order);
			server->instance_set_layer_mask(cell.instances[o], settings.render_layers);
			show(cell, order);
		}
	}
}
