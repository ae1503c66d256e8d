// SPDX-License-Identifier: MIT
#include "src/star_catalogue_format.h"

#include "src/star_catalogue.h"

namespace {

const char *const CATALOGUE_ENDING = "stars";

godot::PackedStringArray catalogue_endings() {
	godot::PackedStringArray listed;
	listed.push_back(CATALOGUE_ENDING);
	return listed;
}

} // namespace

godot::PackedStringArray StarCatalogueLoader::_get_recognized_extensions() const {
	return catalogue_endings();
}

bool StarCatalogueLoader::_handles_type(const godot::StringName &type) const {
	return type == godot::StringName("StarCatalogue") || type == godot::StringName("Resource");
}

godot::String StarCatalogueLoader::_get_resource_type(const godot::String &path) const {
	return path.get_extension().to_lower() == CATALOGUE_ENDING ? "StarCatalogue" : "";
}

godot::Variant StarCatalogueLoader::_load(const godot::String &path, const godot::String & /*original_path*/,
		bool /*use_sub_threads*/, int32_t /*cache_mode*/) const {
	godot::Ref<StarCatalogue> loaded;
	loaded.instantiate();
	const godot::Error error = loaded->load_file(path);
	return error == godot::OK ? godot::Variant(loaded) : godot::Variant(static_cast<int64_t>(error));
}

bool StarCatalogueSaver::_recognize(const godot::Ref<godot::Resource> &resource) const {
	return godot::Object::cast_to<StarCatalogue>(resource.ptr()) != nullptr;
}

godot::PackedStringArray StarCatalogueSaver::_get_recognized_extensions(
		const godot::Ref<godot::Resource> &resource) const {
	return _recognize(resource) ? catalogue_endings() : godot::PackedStringArray();
}

godot::Error StarCatalogueSaver::_save(
		const godot::Ref<godot::Resource> &resource, const godot::String &path, uint32_t /*flags*/) {
	const auto *saved = godot::Object::cast_to<StarCatalogue>(resource.ptr());
	return saved != nullptr ? saved->save_file(path) : godot::ERR_INVALID_PARAMETER;
}
