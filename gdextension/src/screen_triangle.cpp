// SPDX-License-Identifier: MIT
#include "src/screen_triangle.h"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include "src/draw_order.h"

using namespace godot;

namespace {

/// In clip coordinates.
RID make_mesh(RenderingServer *server) {
	PackedVector3Array vertices;
	vertices.push_back(Vector3(-1, -1, 0));
	vertices.push_back(Vector3(3, -1, 0));
	vertices.push_back(Vector3(-1, 3, 0));
	Array arrays;
	arrays.resize(RenderingServer::ARRAY_MAX);
	arrays[RenderingServer::ARRAY_VERTEX] = vertices;
	RID mesh = server->mesh_create();
	server->mesh_add_surface_from_arrays(mesh, RenderingServer::PRIMITIVE_TRIANGLES, arrays);
	return mesh;
}

} // namespace

void ScreenTriangle::make(int render_priority) {
	if (is_made()) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	material = server->material_create();
	server->material_set_render_priority(material, render_priority);
	mesh = make_mesh(server);
	instance = server->instance_create();
	server->instance_set_base(instance, mesh);
	server->instance_set_custom_aabb(instance, everywhere());
	server->instance_geometry_set_material_override(instance, material);
	server->instance_geometry_set_cast_shadows_setting(instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
}

void ScreenTriangle::clear() {
	RenderingServer *server = RenderingServer::get_singleton();
	if (server == nullptr || !is_made()) {
		return;
	}
	server->free_rid(instance);
	server->free_rid(mesh);
	server->free_rid(material);
	instance = mesh = material = RID();
}

void ScreenTriangle::set_scenario(const RID &scenario) {
	RenderingServer::get_singleton()->instance_set_scenario(instance, scenario);
}

void ScreenTriangle::set_visible(bool visible) {
	RenderingServer::get_singleton()->instance_set_visible(instance, visible);
}

void ScreenTriangle::set_render_priority(int priority) {
	RenderingServer::get_singleton()->material_set_render_priority(material, priority);
}

void ScreenTriangle::set_render_layers(uint32_t layers) {
	RenderingServer::get_singleton()->instance_set_layer_mask(instance, layers);
}

void ScreenTriangle::set_shader(const RID &shader) {
	RenderingServer::get_singleton()->material_set_shader(material, shader);
}

void ScreenTriangle::set_parameter(const StringName &name, const Variant &value) {
	RenderingServer::get_singleton()->material_set_param(material, name, value);
}
