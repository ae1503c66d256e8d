// SPDX-License-Identifier: MIT
// A node that overrides virtual methods, receives notifications and draws through the RenderingServer.
#pragma once

#include "probe_resource.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/rid.hpp>

class ProbeNode : public godot::Node3D {
	GDCLASS(ProbeNode, godot::Node3D)

public:
	ProbeNode();
	~ProbeNode() override;

	void _enter_tree() override;
	void _ready() override;
	void _process(double delta) override;
	void _exit_tree() override;
	godot::PackedStringArray _get_configuration_warnings() const override;

	void set_resource(const godot::Ref<ProbeResource> &resource);
	godot::Ref<ProbeResource> get_resource() const { return resource_; }

	int get_frames() const { return frames_; }
	godot::PackedStringArray get_events() const { return events_; }
	int get_changes() const { return changes_; }
	godot::Ref<godot::Image> get_picture() const { return picture_; }
	godot::Dictionary describe_scene() const;

	static int get_live_count() { return live_; }

protected:
	static void _bind_methods();
	void _notification(int what);
	godot::String _to_string() const;

private:
	void on_resource_changed();
	void build_visual();

	godot::Ref<ProbeResource> resource_;
	godot::Ref<godot::Image> picture_;
	godot::Ref<godot::ImageTexture> texture_;
	godot::PackedStringArray events_;
	godot::RID multimesh_;
	godot::RID instance_;
	int frames_ = 0;
	int changes_ = 0;
	static inline std::atomic<int> live_ = 0;
};

// Inherits from another class of the extension: every override above must still work, this one in front.
class ProbeChildNode : public ProbeNode {
	GDCLASS(ProbeChildNode, ProbeNode)

public:
	void _ready() override;
	int get_child_notifications() const { return child_notifications_; }
	int get_frames_twice() const { return 2 * get_frames(); }

protected:
	static void _bind_methods();
	void _notification(int what);

private:
	int child_notifications_ = 0;
};
