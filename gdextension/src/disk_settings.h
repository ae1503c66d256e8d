// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <godot_cpp/variant/basis.hpp>

/// What an accretion disk looks like; lengths in r_s, times in r_s/c.
struct DiskSettings {
	/// The numbers of accretion_disk.gdshaderinc.
	enum Look { kPhysical, kTurbulent, kCheckerboard, kTemperature, kRedshift, kRings };
	static constexpr std::size_t kMostRings = 8;

	godot::Basis axes; ///< world; the y axis is the disk's normal
	double outer_radius = 15.0;
	double outer_fade = 0.3;           ///< share of the outer radius over which the disk thins out
	bool retrograde = false;           ///< the gas turns left-handedly about the normal
	bool plunging = false;             ///< gas within the last stable orbit is shown
	double plunging_temperature = 0.7; ///< over that of the hottest ring
	double peak_temperature = 6500.0;  ///< K, of the hottest ring
	double brightness_ev = 0.0;        ///< 0: that of black bodies
	double opacity = 1.0;              ///< seen face on
	bool limb_darkening = false;
	int orders = 3;
	Look look = kPhysical;
	double contrast = 0.9;  ///< of turbulence
	double lifetime = 60.0; ///< of an eddy
	int sectors = 24;       ///< of the checkerboard
	double checker_ring_width = 1.0;
	std::vector<double> rings{1.5, 2.0, 3.0, 4.0, 6.0, 10.0}; ///< radii of circles
	int ring_highlight = -1;                                  ///< the circle that stands out; -1: none
	double ring_width = 2.0;                                  ///< pixels of a picture of 720 rows
	double time = 0.0;
};
