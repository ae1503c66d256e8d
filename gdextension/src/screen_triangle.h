// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstdint>

/// A triangle that covers the picture of every camera, with a material of its own, made on the
/// RenderingServer: what a layer of the whole view is drawn with.
class ScreenTriangle {
public:
	ScreenTriangle() = default;
	ScreenTriangle(const ScreenTriangle &) = delete;
	ScreenTriangle &operator=(const ScreenTriangle &) = delete;
	~ScreenTriangle() { clear(); }

	/// Makes it; of several that are transparent, those of lower priority are drawn first.
	void make(int render_priority);
	void clear();
	bool is_made() const { return instance.is_valid(); }

	/// An invalid one takes it out of every world.
	void set_scenario(const godot::RID &scenario);
	void set_visible(bool visible);
	void set_render_priority(int priority);
	void set_render_layers(uint32_t layers);
	void set_shader(const godot::RID &shader);
	void set_parameter(const godot::StringName &name, const godot::Variant &value);
	const godot::RID &get_material() const { return material; }

private:
	godot::RID material;
	godot::RID mesh;
	godot::RID instance;
};
