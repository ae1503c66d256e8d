// SPDX-License-Identifier: MIT
#include "probe_node.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

ProbeNode::ProbeNode() {
	++live_;
	set_notify_transform(true); // the engine's object exists already in the constructor
}

ProbeNode::~ProbeNode() {
	RenderingServer *server = RenderingServer::get_singleton();
	if (instance_.is_valid()) {
		server->free_rid(instance_);
	}
	if (multimesh_.is_valid()) {
		server->free_rid(multimesh_);
	}
	--live_;
}

void ProbeNode::_enter_tree() {
	events_.push_back("enter_tree");
	build_visual();
}

void ProbeNode::_ready() {
	events_.push_back("ready");
	set_process(true);
}

void ProbeNode::_process(double delta) {
	if (delta >= 0.0) {
		++frames_;
	}
}

void ProbeNode::_exit_tree() {
	events_.push_back("exit_tree");
}

PackedStringArray ProbeNode::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (resource_.is_null()) {
		warnings.push_back("Assign a resource.");
	}
	return warnings;
}

void ProbeNode::_notification(int what) {
	if (what == NOTIFICATION_POSTINITIALIZE) {
		events_.push_back("postinitialize");
	} else if (what == NOTIFICATION_TRANSFORM_CHANGED) {
		events_.push_back("transform_changed");
	}
}

String ProbeNode::_to_string() const {
	return vformat("ProbeNode with %d frames", frames_);
}

void ProbeNode::set_resource(const Ref<ProbeResource> &resource) {
	if (resource == resource_) {
		return;
	}
	const Callable changed = callable_mp(this, &ProbeNode::on_resource_changed);
	if (resource_.is_valid() && resource_->is_connected("changed", changed)) {
		resource_->disconnect("changed", changed);
	}
	resource_ = resource;
	if (resource_.is_valid()) {
		resource_->connect("changed", changed);
	}
	update_configuration_warnings();
	emit_signal("resource_changed");
}

void ProbeNode::on_resource_changed() {
	++changes_;
}

void ProbeNode::build_visual() {
	RenderingServer *server = RenderingServer::get_singleton();
	PackedByteArray bytes;
	bytes.resize(2 * 2 * 4);
	for (int64_t index = 0; index < bytes.size(); ++index) {
		bytes.ptrw()[index] = static_cast<uint8_t>(index * 10);
	}
	picture_ = Image::create_from_data(2, 2, false, Image::FORMAT_RGBA8, bytes);
	texture_ = ImageTexture::create_from_image(picture_);

	multimesh_ = server->multimesh_create();
	server->multimesh_allocate_data(multimesh_, 4, RenderingServer::MULTIMESH_TRANSFORM_3D);
	PackedFloat32Array buffer;
	buffer.resize(4 * 12);
	buffer.fill(0.0);
	server->multimesh_set_buffer(multimesh_, buffer);
	instance_ = server->instance_create2(multimesh_, get_world_3d()->get_scenario());
	server->instance_set_custom_aabb(instance_, AABB(Vector3(-1, -1, -1), Vector3(2, 2, 2)));
	server->instance_set_transform(instance_, get_global_transform());
}

Dictionary ProbeNode::describe_scene() const {
	Dictionary scene;
	scene["parent"] = get_parent();
	scene["root_is_window"] = Object::cast_to<Window>(get_viewport()) != nullptr;
	scene["same_root"] = static_cast<Node *>(get_tree()->get_root()) == static_cast<Node *>(get_viewport());
	scene["in_editor"] = Engine::get_singleton()->is_editor_hint();
	scene["origin"] = get_global_transform().origin;
	scene["children"] = get_children();
	scene["texture_size"] =
			texture_.is_valid() ? Vector2i(texture_->get_width(), texture_->get_height()) : Vector2i();
	return scene;
}

void ProbeNode::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_resource", "resource"), &ProbeNode::set_resource);
	ClassDB::bind_method(D_METHOD("get_resource"), &ProbeNode::get_resource);
	ClassDB::bind_method(D_METHOD("get_frames"), &ProbeNode::get_frames);
	ClassDB::bind_method(D_METHOD("get_events"), &ProbeNode::get_events);
	ClassDB::bind_method(D_METHOD("get_changes"), &ProbeNode::get_changes);
	ClassDB::bind_method(D_METHOD("get_picture"), &ProbeNode::get_picture);
	ClassDB::bind_method(D_METHOD("describe_scene"), &ProbeNode::describe_scene);
	ClassDB::bind_static_method("ProbeNode", D_METHOD("get_live_count"), &ProbeNode::get_live_count);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "resource", PROPERTY_HINT_RESOURCE_TYPE, "ProbeResource"),
			"set_resource", "get_resource");
	ADD_SIGNAL(MethodInfo("resource_changed"));
}

void ProbeChildNode::_ready() {
	ProbeNode::_ready();
	set_name("ChildIsReady");
}

void ProbeChildNode::_notification(int /*what*/) {
	++child_notifications_;
}

void ProbeChildNode::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_child_notifications"), &ProbeChildNode::get_child_notifications);
	ClassDB::bind_method(D_METHOD("get_frames_twice"), &ProbeChildNode::get_frames_twice);
}
