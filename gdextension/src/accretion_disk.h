// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include "core/disk/disk_glow.h"
#include "src/disk_layer.h"
#include "src/disk_settings.h"

class BlackHoleSky;

/// A thin accretion disk round the hole of the BlackHoleSky that is its parent; its y axis is the disk's
/// normal. Radii in Schwarzschild radii, times in the light's travel time over one.
class AccretionDisk : public godot::Node3D {
	GDCLASS(AccretionDisk, godot::Node3D)

public:
	enum Look : int {
		LOOK_PHYSICAL = DiskSettings::kPhysical,
		LOOK_TURBULENT = DiskSettings::kTurbulent,
		LOOK_CHECKERBOARD = DiskSettings::kCheckerboard,
		LOOK_TEMPERATURE = DiskSettings::kTemperature,
		LOOK_REDSHIFT = DiskSettings::kRedshift,
		LOOK_RINGS = DiskSettings::kRings,
	};

	AccretionDisk();

	void set_outer_radius(double radius);
	double get_outer_radius() const { return settings.outer_radius; }
	void set_outer_fade(double share);
	double get_outer_fade() const { return settings.outer_fade; }
	void set_retrograde(bool on);
	bool is_retrograde() const { return settings.retrograde; }
	void set_plunging_gas(bool shown);
	bool has_plunging_gas() const { return settings.plunging; }
	void set_plunging_temperature(double share);
	double get_plunging_temperature() const { return settings.plunging_temperature; }
	void set_peak_temperature(double kelvin);
	double get_peak_temperature() const { return peak_temperature; }
	void set_accretion_rate(double masses_per_year);
	double get_accretion_rate() const { return accretion_rate; }
	double get_hottest_temperature() const;
	void set_brightness_ev(double ev);
	double get_brightness_ev() const { return settings.brightness_ev; }
	void set_opacity(double share);
	double get_opacity() const { return settings.opacity; }
	void set_limb_darkening(bool on);
	bool is_limb_darkening() const { return settings.limb_darkening; }
	void set_orders(int orders);
	int get_orders() const { return settings.orders; }
	void set_look(Look look);
	Look get_look() const { return static_cast<Look>(settings.look); }
	void set_turbulence(double contrast);
	double get_turbulence() const { return settings.contrast; }
	void set_eddy_lifetime(double time);
	double get_eddy_lifetime() const { return settings.lifetime; }
	void set_checker_sectors(int sectors);
	int get_checker_sectors() const { return settings.sectors; }
	void set_checker_ring_width(double width);
	double get_checker_ring_width() const { return settings.checker_ring_width; }
	void set_ring_radii(const godot::PackedFloat32Array &radii);
	godot::PackedFloat32Array get_ring_radii() const;
	void set_ring_highlight(int place);
	int get_ring_highlight() const { return settings.ring_highlight; }
	void set_ring_width(double pixels);
	double get_ring_width() const { return settings.ring_width; }
	void set_time(double time);
	double get_time() const { return settings.time; }
	void set_time_scale(double factor);
	double get_time_scale() const { return time_scale; }

	static double page_thorne_temperature(double radius);
	static double orbital_period(double radius);

	godot::PackedStringArray _get_configuration_warnings() const override;
	void _process(double delta) override;

	/// The sky tells what has changed: its settings (with the hole where it is, and never without one), the
	/// hole's size against the node's, and the table.
	void sky_changed(const SkySettings &sky, double hole_scale, const godot::Ref<LensingTable> &table);
	void redshift_map_changed(bool shown) { layer.set_redshift_map(shown); }
	/// The disk as an exposure meter sees it; nothing while it is hidden or shows what is no light.
	std::optional<blackhole::GlowingDisk> metered(double hole_scale) const;

protected:
	static void _bind_methods();
	void _notification(int what);

private:
	void enter_world();
	void exit_world();
	void changed();
	void redraw_gizmo();
	BlackHoleSky *parent_sky() const;

	DiskLayer layer;
	DiskSettings settings;
	double peak_temperature = 6500.0;
	double accretion_rate = 0.0; ///< solar masses a year; 0: the peak temperature is given
	double time_scale = 0.0;
};

VARIANT_ENUM_CAST(AccretionDisk::Look);
