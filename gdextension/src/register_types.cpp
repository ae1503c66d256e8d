// SPDX-License-Identifier: MIT
#include "src/register_types.h"

#include "src/accretion_disk.h"
#include "src/black_body.h"
#include "src/black_hole_sky.h"
#include "src/circular_orbit_path.h"
#include "src/empty_cubemap.h"
#include "src/figure_field.h"
#include "src/lensing_table.h"
#include "src/piloted_observer.h"
#include "src/planck_texture.h"
#include "src/radial_fall_path.h"
#include "src/resource_formats.h"
#include "src/sky_observer.h"
#include "src/star_catalogue.h"

#include <gdextension_interface.h>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

void initialize_blackhole_sky(godot::ModuleInitializationLevel level) {
	if (level != godot::MODULE_INITIALIZATION_LEVEL_SCENE) {
		return;
	}
	GDREGISTER_CLASS(BlackBody);
	GDREGISTER_CLASS(StarCatalogue);
	GDREGISTER_CLASS(LensingTable);
	GDREGISTER_CLASS(FigureField);
	GDREGISTER_CLASS(SkyObserver);
	GDREGISTER_CLASS(BlackHoleSky);
	GDREGISTER_CLASS(AccretionDisk);
	GDREGISTER_CLASS(RadialFallPath);
	GDREGISTER_CLASS(CircularOrbitPath);
	GDREGISTER_CLASS(PilotedObserver);
	register_resource_formats();
}

void uninitialize_blackhole_sky(godot::ModuleInitializationLevel level) {
	if (level == godot::MODULE_INITIALIZATION_LEVEL_SCENE) {
		unregister_resource_formats();
		release_planck_texture();
		release_empty_cubemap();
	}
}

extern "C" GDExtensionBool GDE_EXPORT blackhole_sky_init(GDExtensionInterfaceGetProcAddress get_proc_address,
		GDExtensionClassLibraryPtr library, GDExtensionInitialization *initialization) {
	const godot::GDExtensionBinding::InitObject init(get_proc_address, library, initialization);
	init.register_initializer(initialize_blackhole_sky);
	init.register_terminator(uninitialize_blackhole_sky);
	init.set_minimum_library_initialization_level(godot::MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
