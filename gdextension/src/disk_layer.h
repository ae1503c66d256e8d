// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/variant/rid.hpp>

#include "src/disk_settings.h"
#include "src/lensing_table.h"
#include "src/screen_triangle.h"
#include "src/sky_settings.h"

/// Draws an accretion disk: a triangle over the picture whose pixels look for the disk along their lines of
/// sight. What it needs is made when it is first shown; hidden it costs nothing.
class DiskLayer {
public:
	/// An invalid scenario takes it out of every world.
	void set_scenario(const godot::RID &scenario);
	void set_shown(bool shown);
	/// The hole, the observers and the tables; `hole_scale`: r_s of the settings in the node's, below 1 while
	/// the hole is made to vanish. Without a table nothing is drawn. With the disk as it is then.
	void set_sky(const SkySettings &settings, double hole_scale, const godot::Ref<LensingTable> &table,
			const DiskSettings &disk_then);
	void set_redshift_map(bool shown);
	void set_disk(const DiskSettings &settings);
	void set_time(const DiskSettings &settings);

private:
	bool is_drawn() const;
	void refresh();
	void make();
	void dress();
	void load_shader();
	void dress_rings();

	ScreenTriangle triangle;
	godot::Ref<godot::Shader> shader;
	godot::RID scenario;
	SkySettings sky;
	DiskSettings disk;
	godot::Ref<LensingTable> table;
	double hole_scale = 1.0;
	SkyShaders loaded = SkyShaders::kFlat; ///< which `shader` is
	bool loaded_plain = false;
	bool shown = false;
	bool redshift_map = false;
};
