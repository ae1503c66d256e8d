// SPDX-License-Identifier: MIT
// What is drawn with the settings of a BlackHoleSky besides its layers: disks, and materials of the project's
// own.
#include "src/black_hole_sky.h"

#include <algorithm>

#include "src/accretion_disk.h"

using namespace godot;

void BlackHoleSky::apply_to_disks() {
	if (disks.empty()) {
		return;
	}
	// A disk that has no hole any more is one whose hole is tiny.
	SkySettings &around = disk_sources.settings;
	around = settings;
	around.hole_position = get_global_transform().origin;
	around.inverse_radius = 1.0 / (schwarzschild_radius * hole_scale());
	for (AccretionDisk *disk : disks) {
		disk->sky_changed(around, hole_scale(), table);
	}
}

void BlackHoleSky::apply_to_materials() {
	for (const Ref<Material> &material : materials) {
		set_sky_uniforms(material->get_rid(), settings);
	}
}

void BlackHoleSky::add_material(const Ref<Material> &material) {
	if (material.is_valid() && std::find(materials.begin(), materials.end(), material) == materials.end()) {
		materials.push_back(material);
		settings_changed();
	}
}

void BlackHoleSky::remove_material(const Ref<Material> &material) {
	materials.erase(std::remove(materials.begin(), materials.end(), material), materials.end());
}

void BlackHoleSky::add_disk(AccretionDisk *disk) {
	disks.push_back(disk);
	disk->redshift_map_changed(redshift_map);
	settings_changed();
}

void BlackHoleSky::remove_disk(AccretionDisk *disk) {
	disks.erase(std::remove(disks.begin(), disks.end(), disk), disks.end());
}
