// SPDX-License-Identifier: MIT
#include "src/resource_formats.h"

#include "src/lensing_table_format.h"
#include "src/star_catalogue_format.h"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/resource_saver.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace {

/// The engine keeps loaders and savers as long as it has not been told otherwise.
struct Formats {
	godot::Ref<LensingTableLoader> table_loader;
	godot::Ref<LensingTableSaver> table_saver;
	godot::Ref<StarCatalogueLoader> catalogue_loader;
	godot::Ref<StarCatalogueSaver> catalogue_saver;
};

Formats &formats() {
	static Formats known;
	return known;
}

} // namespace

void register_resource_formats() {
	GDREGISTER_INTERNAL_CLASS(LensingTableLoader);
	GDREGISTER_INTERNAL_CLASS(LensingTableSaver);
	GDREGISTER_INTERNAL_CLASS(StarCatalogueLoader);
	GDREGISTER_INTERNAL_CLASS(StarCatalogueSaver);
	Formats &known = formats();
	known.table_loader.instantiate();
	known.table_saver.instantiate();
	known.catalogue_loader.instantiate();
	known.catalogue_saver.instantiate();
	godot::ResourceLoader *loader = godot::ResourceLoader::get_singleton();
	loader->add_resource_format_loader(known.table_loader);
	loader->add_resource_format_loader(known.catalogue_loader);
	godot::ResourceSaver *saver = godot::ResourceSaver::get_singleton();
	saver->add_resource_format_saver(known.table_saver);
	saver->add_resource_format_saver(known.catalogue_saver);
}

void unregister_resource_formats() {
	Formats &known = formats();
	godot::ResourceLoader *loader = godot::ResourceLoader::get_singleton();
	loader->remove_resource_format_loader(known.table_loader);
	loader->remove_resource_format_loader(known.catalogue_loader);
	godot::ResourceSaver *saver = godot::ResourceSaver::get_singleton();
	saver->remove_resource_format_saver(known.table_saver);
	saver->remove_resource_format_saver(known.catalogue_saver);
	known = {};
}
