// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/cubemap.hpp>
#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include "src/background_layer.h"
#include "src/exposure_meter.h"
#include "src/eye_tracker.h"
#include "src/horizon_watch.h"
#include "src/lensing_table.h"
#include "src/sky_observer.h"
#include "src/sky_settings.h"
#include "src/star_catalogue.h"
#include "src/star_choice.h"
#include "src/star_layer.h"

class AccretionDisk;

/// A Schwarzschild black hole at the node's place and the sky as its light bends it, right for every camera
/// and eye that looks at the node's world.
class BlackHoleSky : public godot::Node3D {
	GDCLASS(BlackHoleSky, godot::Node3D)

public:
	/// Effects that can be switched off alone: the bits of effects.gdshaderinc.
	enum Effect : int {
		EFFECT_DEFLECTION = 1,
		EFFECT_ABERRATION = 2,
		EFFECT_GRAVITATIONAL_SHIFT = 4,
		EFFECT_DOPPLER = 8,
		EFFECT_MAGNIFICATION = 16,
	};
	/// Lines over the sky: the bits of overlays.gdshaderinc.
	enum Overlay : int {
		OVERLAY_CONSTELLATIONS = 1,
		OVERLAY_EQUATORIAL_GRID = 2,
		OVERLAY_GALACTIC_GRID = 4,
		OVERLAY_SHADOW_EDGE = 8,
		OVERLAY_EINSTEIN_RINGS = 16,
		OVERLAY_MOTION = 32,
		OVERLAY_SHADOW_DIAMETER = 64,
		OVERLAY_STRAIGHT_LIGHT = 128,
	};
	/// How directions are laid out on the picture: the numbers of map_projection.gdshaderinc.
	enum Projection : int {
		PROJECTION_PERSPECTIVE = 0,
		PROJECTION_EQUIRECTANGULAR = 1,
		PROJECTION_MERCATOR = 2,
		PROJECTION_MOLLWEIDE = 3,
		PROJECTION_FISHEYE_180 = 4,
		PROJECTION_FISHEYE_220 = 5,
		PROJECTION_FISHEYE_360 = 6,
	};
	/// How the light of a star spreads.
	enum PointSpreadModel : int { PSF_GAUSSIAN = 0, PSF_AIRY = 1, PSF_EYE = 2 };
	/// What lies behind the stars: the numbers of background.gdshaderinc.
	enum Background : int {
		BACKGROUND_NONE = 0,
		BACKGROUND_GRID = 1,
		BACKGROUND_PANORAMA = 2,
		BACKGROUND_CUBEMAP = 3,
		BACKGROUND_SURROUNDINGS = 4,
	};

	BlackHoleSky();

	void set_schwarzschild_radius(double metres);
	double get_schwarzschild_radius() const { return schwarzschild_radius; }
	void set_mass_solar(double masses);
	double get_mass_solar() const { return mass_solar; }
	double get_length_unit_km() const;
	double get_time_unit_seconds() const;
	double get_acceleration_unit_g() const;
	void set_lensing(double fraction);
	double get_lensing() const { return lensing; }
	void set_observer_motion(LensingTable::Motion motion);
	LensingTable::Motion get_observer_motion() const;
	void set_observer(const godot::Ref<SkyObserver> &p_observer);
	godot::Ref<SkyObserver> get_observer() const { return observer; }
	void set_table(const godot::Ref<LensingTable> &p_table);
	godot::Ref<LensingTable> get_table() const { return table; }

	void set_catalogue(const godot::Ref<StarCatalogue> &p_catalogue);
	godot::Ref<StarCatalogue> get_catalogue() const { return catalogue; }
	void set_stars_visible(bool shown);
	bool are_stars_visible() const { return stars_visible; }
	void set_magnitude_limit(double magnitude);
	double get_magnitude_limit() const { return magnitude_limit; }
	void set_image_orders(int orders);
	int get_image_orders() const { return image_orders; }
	void set_psf_model(PointSpreadModel model);
	PointSpreadModel get_psf_model() const { return psf_model; }
	void set_psf_sigma(double pixels);
	double get_psf_sigma() const { return psf_sigma; }
	void set_aperture_mm(double millimetres);
	double get_aperture_mm() const { return aperture_mm; }
	void set_glare(double share);
	double get_glare() const { return glare; }
	void set_faint_limit(double luminance);
	double get_faint_limit() const { return faint_limit; }

	void set_effect(int effect, bool on);
	bool is_effect_on(int effect) const { return (effects & effect) != 0; }
	void set_higher_orders(bool shown);
	bool are_higher_orders_shown() const { return higher_orders; }
	void set_saturation(double factor);
	double get_saturation() const { return saturation; }
	void set_stereo_baseline_scale(double factor);
	double get_stereo_baseline_scale() const { return stereo_baseline_scale; }
	void set_see_through(double share);
	double get_see_through() const { return see_through; }
	void set_redshift_map(bool shown);
	bool is_redshift_map_shown() const { return redshift_map; }

	void set_overlays(int shown);
	int get_overlays() const { return overlays; }
	void set_overlay_width(double pixels);
	double get_overlay_width() const { return overlay_width; }
	void set_figure_field(const godot::Ref<godot::Cubemap> &field);
	godot::Ref<godot::Cubemap> get_figure_field() const { return figure_field; }
	void set_projection(Projection kind);
	Projection get_projection() const { return projection; }
	void set_exposure(double ev);
	double get_exposure() const { return exposure; }
	void set_auto_exposure(bool on);
	bool is_auto_exposure() const { return auto_exposure; }
	void set_auto_exposure_min_ev(double ev);
	double get_auto_exposure_min_ev() const { return exposure_meter.limits.least; }
	void set_auto_exposure_max_ev(double ev);
	double get_auto_exposure_max_ev() const { return exposure_meter.limits.most; }
	void set_adaptation_speed(double factor);
	double get_adaptation_speed() const { return exposure_meter.speed; }
	double get_effective_exposure() const;
	void adapt(double seconds);
	void adapt_at_once();
	void set_background(Background kind);
	Background get_background() const { return background; }
	void set_panorama(const godot::Ref<godot::Texture2D> &texture);
	godot::Ref<godot::Texture2D> get_panorama() const { return panorama; }
	void set_cubemap(const godot::Ref<godot::Cubemap> &texture);
	godot::Ref<godot::Cubemap> get_cubemap() const { return cubemap; }
	void set_surroundings(const godot::Ref<godot::Texture2D> &texture);
	godot::Ref<godot::Texture2D> get_surroundings() const { return surroundings; }
	void set_panorama_luminance(double luminance);
	double get_panorama_luminance() const { return panorama_luminance; }
	void set_panorama_is_light(bool is_light);
	bool is_panorama_light() const { return panorama_is_light; }
	void set_render_layers(uint32_t layers);
	uint32_t get_render_layers() const { return render_layers; }

	/// Materials of the project's own that see as the sky's do.
	void add_material(const godot::Ref<godot::Material> &material);
	void remove_material(const godot::Ref<godot::Material> &material);

	/// Disks round the hole say that they are there.
	void add_disk(AccretionDisk *disk);
	void remove_disk(AccretionDisk *disk);

	double distance_to(const godot::Vector3 &world_position) const;
	double shadow_angle_at(const godot::Vector3 &world_position) const;
	godot::String get_observer_refusal_at(const godot::Vector3 &world_position) const;
	godot::Vector2 project_image(godot::Camera3D *camera, const godot::Vector3 &direction, int order);
	int64_t get_star_buffer_bytes() const { return star_layer.buffer_bytes(); }
	double get_update_time_ms() const { return update_time_ms; }

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int what);

private:
	void enter_world();
	void exit_world();
	void settings_changed();
	void observer_changed();
	template <typename Value>
	void set_quality(Value &kept, Value value);
	bool tell_of_horizon(const std::vector<WatchingEye> &eyes);
	void apply_background();
	void apply_settings();
	void apply_to_disks();
	void apply_to_materials();
	void catalogue_changed();
	void table_changed();
	void before_draw();
	bool is_metering() const;
	void meter(const WatchingEye &eye, double seconds, bool all);
	void meter_now(double seconds);
	void node_added(godot::Node *node);
	void node_removed(godot::Node *node);
	bool is_lensing() const;
	double hole_scale() const; ///< of the hole that is drawn, above 0 also where it counts as none
	SkyShaders shaders_needed() const;
	blackhole::ObserverField observer_field() const;
	godot::Vector3 place_of(const godot::Vector3 &world_position) const;

	StarLayer star_layer;
	BackgroundLayer background_layer;
	EyeTracker eye_tracker;
	HorizonWatch horizon_watch;
	StarChoice star_choice;
	ExposureMeter exposure_meter;
	SkySettings settings;
	std::vector<AccretionDisk *> disks;
	std::vector<godot::Ref<godot::Material>> materials;
	ExposureMeter::DiskSources disk_sources; ///< with the settings by which the disks are drawn

	double schwarzschild_radius = 1.0;
	double mass_solar = 10.0;
	double lensing = 1.0;
	godot::Ref<SkyObserver> observer; ///< null: static
	int effects = lensing_shader::kAllEffects;
	bool higher_orders = true;
	double saturation = 1.0;
	double stereo_baseline_scale = 1.0;
	double see_through = 0.0;
	Projection projection = PROJECTION_PERSPECTIVE;
	int overlays = 0;
	double overlay_width = 1.5;
	godot::Ref<godot::Cubemap> figure_field;
	bool redshift_map = false;
	godot::Ref<LensingTable> table;
	godot::Ref<StarCatalogue> catalogue;
	bool stars_visible = true;
	double magnitude_limit = 12.0;
	int image_orders = 2;
	PointSpreadModel psf_model = PSF_GAUSSIAN;
	double psf_sigma = 1.0;
	double aperture_mm = 5.0;
	double glare = 0.616;
	double faint_limit = 5e-5;
	double exposure = 0.0;
	bool auto_exposure = false;
	double applied_exposure = 0.0; ///< EV, of the settings
	Background background = BACKGROUND_NONE;
	godot::Ref<godot::Texture2D> panorama;
	godot::Ref<godot::Cubemap> cubemap;
	godot::Ref<godot::Texture2D> surroundings;
	double panorama_luminance = 1.0;
	bool panorama_is_light = true;
	uint32_t render_layers = 1;

	double update_time_ms = 0.0;
	bool settings_dirty = false;
	bool reads_cubemaps = true; ///< back from the graphics card
};

VARIANT_ENUM_CAST(BlackHoleSky::Background);
VARIANT_ENUM_CAST(BlackHoleSky::Effect);
VARIANT_ENUM_CAST(BlackHoleSky::Projection);
VARIANT_ENUM_CAST(BlackHoleSky::Overlay);
VARIANT_ENUM_CAST(BlackHoleSky::PointSpreadModel);
