// SPDX-License-Identifier: MIT
#include "src/star_catalogue_format.h"

#include "src/resource_file_format.h"
#include "src/star_catalogue.h"

namespace {

constexpr ResourceFileFormat<StarCatalogue> kCatalogueFormat("StarCatalogue", "stars");

} // namespace

godot::PackedStringArray StarCatalogueLoader::_get_recognized_extensions() const {
	return kCatalogueFormat.endings();
}

bool StarCatalogueLoader::_handles_type(const godot::StringName &type) const {
	return kCatalogueFormat.handles(type);
}

godot::String StarCatalogueLoader::_get_resource_type(const godot::String &path) const {
	return kCatalogueFormat.type_of(path);
}

godot::Variant StarCatalogueLoader::_load(const godot::String &path, const godot::String & /*original_path*/,
		bool /*use_sub_threads*/, int32_t /*cache_mode*/) const {
	return kCatalogueFormat.load(path);
}

bool StarCatalogueSaver::_recognize(const godot::Ref<godot::Resource> &resource) const {
	return kCatalogueFormat.recognizes(resource);
}

godot::PackedStringArray StarCatalogueSaver::_get_recognized_extensions(
		const godot::Ref<godot::Resource> &resource) const {
	return kCatalogueFormat.endings_for(resource);
}

godot::Error StarCatalogueSaver::_save(
		const godot::Ref<godot::Resource> &resource, const godot::String &path, uint32_t /*flags*/) {
	return kCatalogueFormat.save(resource, path);
}
