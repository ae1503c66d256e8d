// SPDX-License-Identifier: MIT
// What the engine sees of AccretionDisk: properties, methods and the warnings in the editor.
#include "src/accretion_disk.h"

#include "src/black_hole_sky.h"

using namespace godot;

PackedStringArray AccretionDisk::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (parent_sky() == nullptr) {
		warnings.push_back("The disk has no hole. Make it a child of a BlackHoleSky.");
	}
	return warnings;
}

void AccretionDisk::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_outer_radius", "radius"), &AccretionDisk::set_outer_radius);
	ClassDB::bind_method(D_METHOD("get_outer_radius"), &AccretionDisk::get_outer_radius);
	ClassDB::bind_method(D_METHOD("set_outer_fade", "share"), &AccretionDisk::set_outer_fade);
	ClassDB::bind_method(D_METHOD("get_outer_fade"), &AccretionDisk::get_outer_fade);
	ClassDB::bind_method(D_METHOD("set_retrograde", "on"), &AccretionDisk::set_retrograde);
	ClassDB::bind_method(D_METHOD("is_retrograde"), &AccretionDisk::is_retrograde);
	ClassDB::bind_method(D_METHOD("set_plunging_gas", "shown"), &AccretionDisk::set_plunging_gas);
	ClassDB::bind_method(D_METHOD("has_plunging_gas"), &AccretionDisk::has_plunging_gas);
	ClassDB::bind_method(
			D_METHOD("set_plunging_temperature", "share"), &AccretionDisk::set_plunging_temperature);
	ClassDB::bind_method(D_METHOD("get_plunging_temperature"), &AccretionDisk::get_plunging_temperature);
	ClassDB::bind_method(D_METHOD("set_peak_temperature", "kelvin"), &AccretionDisk::set_peak_temperature);
	ClassDB::bind_method(D_METHOD("get_peak_temperature"), &AccretionDisk::get_peak_temperature);
	ClassDB::bind_method(
			D_METHOD("set_accretion_rate", "masses_per_year"), &AccretionDisk::set_accretion_rate);
	ClassDB::bind_method(D_METHOD("get_accretion_rate"), &AccretionDisk::get_accretion_rate);
	ClassDB::bind_method(D_METHOD("set_brightness_ev", "ev"), &AccretionDisk::set_brightness_ev);
	ClassDB::bind_method(D_METHOD("get_brightness_ev"), &AccretionDisk::get_brightness_ev);
	ClassDB::bind_method(D_METHOD("set_opacity", "share"), &AccretionDisk::set_opacity);
	ClassDB::bind_method(D_METHOD("get_opacity"), &AccretionDisk::get_opacity);
	ClassDB::bind_method(D_METHOD("set_limb_darkening", "on"), &AccretionDisk::set_limb_darkening);
	ClassDB::bind_method(D_METHOD("is_limb_darkening"), &AccretionDisk::is_limb_darkening);
	ClassDB::bind_method(D_METHOD("set_orders", "orders"), &AccretionDisk::set_orders);
	ClassDB::bind_method(D_METHOD("get_orders"), &AccretionDisk::get_orders);
	ClassDB::bind_method(D_METHOD("set_look", "look"), &AccretionDisk::set_look);
	ClassDB::bind_method(D_METHOD("get_look"), &AccretionDisk::get_look);
	ClassDB::bind_method(D_METHOD("set_turbulence", "contrast"), &AccretionDisk::set_turbulence);
	ClassDB::bind_method(D_METHOD("get_turbulence"), &AccretionDisk::get_turbulence);
	ClassDB::bind_method(D_METHOD("set_eddy_lifetime", "time"), &AccretionDisk::set_eddy_lifetime);
	ClassDB::bind_method(D_METHOD("get_eddy_lifetime"), &AccretionDisk::get_eddy_lifetime);
	ClassDB::bind_method(D_METHOD("set_checker_sectors", "sectors"), &AccretionDisk::set_checker_sectors);
	ClassDB::bind_method(D_METHOD("get_checker_sectors"), &AccretionDisk::get_checker_sectors);
	ClassDB::bind_method(D_METHOD("set_checker_ring_width", "width"), &AccretionDisk::set_checker_ring_width);
	ClassDB::bind_method(D_METHOD("get_checker_ring_width"), &AccretionDisk::get_checker_ring_width);
	ClassDB::bind_method(D_METHOD("set_ring_radii", "radii"), &AccretionDisk::set_ring_radii);
	ClassDB::bind_method(D_METHOD("get_ring_radii"), &AccretionDisk::get_ring_radii);
	ClassDB::bind_method(D_METHOD("set_ring_highlight", "place"), &AccretionDisk::set_ring_highlight);
	ClassDB::bind_method(D_METHOD("get_ring_highlight"), &AccretionDisk::get_ring_highlight);
	ClassDB::bind_method(D_METHOD("set_ring_width", "pixels"), &AccretionDisk::set_ring_width);
	ClassDB::bind_method(D_METHOD("get_ring_width"), &AccretionDisk::get_ring_width);
	ClassDB::bind_method(D_METHOD("set_time", "time"), &AccretionDisk::set_time);
	ClassDB::bind_method(D_METHOD("get_time"), &AccretionDisk::get_time);
	ClassDB::bind_method(D_METHOD("set_time_scale", "factor"), &AccretionDisk::set_time_scale);
	ClassDB::bind_method(D_METHOD("get_time_scale"), &AccretionDisk::get_time_scale);
	ClassDB::bind_method(D_METHOD("get_hottest_temperature"), &AccretionDisk::get_hottest_temperature);
	ClassDB::bind_static_method("AccretionDisk", D_METHOD("page_thorne_temperature", "radius"),
			&AccretionDisk::page_thorne_temperature);
	ClassDB::bind_static_method(
			"AccretionDisk", D_METHOD("orbital_period", "radius"), &AccretionDisk::orbital_period);

	ADD_GROUP("Gas", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "outer_radius", PROPERTY_HINT_RANGE,
						 "3.1,100,0.1,or_greater,suffix:r_s"),
			"set_outer_radius", "get_outer_radius");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "outer_fade", PROPERTY_HINT_RANGE, "0,1,0.01"),
			"set_outer_fade", "get_outer_fade");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "retrograde"), "set_retrograde", "is_retrograde");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "plunging_gas"), "set_plunging_gas", "has_plunging_gas");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "plunging_temperature", PROPERTY_HINT_RANGE, "0.01,1,0.01"),
			"set_plunging_temperature", "get_plunging_temperature");
	ADD_GROUP("Light", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "peak_temperature", PROPERTY_HINT_RANGE,
						 "250,100000,10,or_greater,suffix:K"),
			"set_peak_temperature", "get_peak_temperature");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "accretion_rate", PROPERTY_HINT_RANGE,
						 String::utf8("0,1,0.000001,or_greater,suffix:M☉/yr")),
			"set_accretion_rate", "get_accretion_rate");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "brightness_ev", PROPERTY_HINT_RANGE,
						 "-60,20,0.1,or_less,or_greater,suffix:EV"),
			"set_brightness_ev", "get_brightness_ev");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "opacity", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_opacity",
			"get_opacity");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "limb_darkening"), "set_limb_darkening", "is_limb_darkening");
	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "orders", PROPERTY_HINT_RANGE, "1,4"), "set_orders", "get_orders");
	ADD_GROUP("Look", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "look", PROPERTY_HINT_ENUM,
						 "Physical,Turbulent,Checkerboard,Temperature,Redshift,Rings"),
			"set_look", "get_look");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "turbulence", PROPERTY_HINT_RANGE, "0,3,0.01"),
			"set_turbulence", "get_turbulence");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "eddy_lifetime", PROPERTY_HINT_RANGE,
						 "1,1000,1,or_greater,suffix:r_s/c"),
			"set_eddy_lifetime", "get_eddy_lifetime");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "checker_sectors", PROPERTY_HINT_RANGE, "2,360,2,suffix:sectors"),
			"set_checker_sectors", "get_checker_sectors");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "checker_ring_width", PROPERTY_HINT_RANGE,
						 "0.05,10,0.05,or_greater,suffix:r_s"),
			"set_checker_ring_width", "get_checker_ring_width");
	ADD_GROUP("Rings", "ring_");
	ADD_PROPERTY(
			PropertyInfo(Variant::PACKED_FLOAT32_ARRAY, "ring_radii"), "set_ring_radii", "get_ring_radii");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "ring_highlight", PROPERTY_HINT_RANGE, "-1,7"),
			"set_ring_highlight", "get_ring_highlight");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "ring_width", PROPERTY_HINT_RANGE, "0.5,5,0.1,or_greater,suffix:px"),
			"set_ring_width", "get_ring_width");
	ADD_GROUP("Motion", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "time", PROPERTY_HINT_RANGE,
						 "0,1000,0.01,or_less,or_greater,suffix:r_s/c"),
			"set_time", "get_time");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "time_scale", PROPERTY_HINT_RANGE,
						 "0,100,0.01,or_less,or_greater,suffix:r_s/c per s"),
			"set_time_scale", "get_time_scale");
	BIND_ENUM_CONSTANT(LOOK_PHYSICAL);
	BIND_ENUM_CONSTANT(LOOK_TURBULENT);
	BIND_ENUM_CONSTANT(LOOK_CHECKERBOARD);
	BIND_ENUM_CONSTANT(LOOK_TEMPERATURE);
	BIND_ENUM_CONSTANT(LOOK_REDSHIFT);
	BIND_ENUM_CONSTANT(LOOK_RINGS);
}
