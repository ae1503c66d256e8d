// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/variant/rid.hpp>

#include "src/screen_triangle.h"
#include "src/sky_settings.h"

/// Pictures of the sky, of which one is shown; those that are not there are invalid.
struct BackgroundPictures {
	godot::RID panorama;
	godot::RID cubemap;
	godot::RID surroundings; ///< laid out as surroundings_layout.gdshaderinc says
};

/// Draws what lies behind the stars: a triangle at the far plane. Owns what it makes on the RenderingServer.
class BackgroundLayer {
public:
	BackgroundLayer() = default;
	BackgroundLayer(const BackgroundLayer &) = delete;
	BackgroundLayer &operator=(const BackgroundLayer &) = delete;
	~BackgroundLayer() = default;

	void set_scenario(const godot::RID &scenario);
	void set_shown(bool shown);
	void set_tables(
			const godot::RID &forward_table, const godot::RID &inverse_table, const godot::RID &planck_table);
	/// Cube map of the vectors to the nearest line of the figures.
	void set_figure_field(const godot::RID &cube_map);
	/// Shows frequency ratios in false colours instead of the sky.
	void set_redshift_map(bool shown);
	/// Whether the picture's light is shifted in frequency.
	void set_panorama_is_light(bool is_light);
	/// kind: BlackHoleSky::Background; luminance of a picture's texel of value 1 at exposure 0.
	void set_source(int kind, const BackgroundPictures &pictures, double luminance);
	void apply(const SkySettings &settings);

private:
	void ensure();
	godot::RID shader(const SkySettings &settings);
	void show();

	godot::Ref<godot::Shader> lensed_shader;
	godot::Ref<godot::Shader> general_shader;
	godot::Ref<godot::Shader> map_shader;
	godot::Ref<godot::Shader> flat_shader;
	/// Those that let the room show through, loaded when they are needed.
	godot::Ref<godot::Shader> clear_lensed_shader;
	godot::Ref<godot::Shader> clear_general_shader;
	ScreenTriangle triangle;
	double panorama_luminance = 1.0;
	SkySettings current;
	bool dressed = false; ///< the material has what the current settings say
	int source = 0;
	bool redshift_map = false;
	bool layer_shown = true;
};
