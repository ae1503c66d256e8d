// SPDX-License-Identifier: MIT
#include "src/lensing_table_format.h"

#include "src/lensing_table.h"

namespace {

const char *const TABLE_ENDING = "lut";

godot::PackedStringArray table_endings() {
	godot::PackedStringArray listed;
	listed.push_back(TABLE_ENDING);
	return listed;
}

} // namespace

godot::PackedStringArray LensingTableLoader::_get_recognized_extensions() const {
	return table_endings();
}

bool LensingTableLoader::_handles_type(const godot::StringName &type) const {
	return type == godot::StringName("LensingTable") || type == godot::StringName("Resource");
}

godot::String LensingTableLoader::_get_resource_type(const godot::String &path) const {
	return path.get_extension().to_lower() == TABLE_ENDING ? "LensingTable" : "";
}

godot::Variant LensingTableLoader::_load(const godot::String &path, const godot::String & /*original_path*/,
		bool /*use_sub_threads*/, int32_t /*cache_mode*/) const {
	godot::Ref<LensingTable> loaded;
	loaded.instantiate();
	const godot::Error error = loaded->load_file(path);
	return error == godot::OK ? godot::Variant(loaded) : godot::Variant(static_cast<int64_t>(error));
}

bool LensingTableSaver::_recognize(const godot::Ref<godot::Resource> &resource) const {
	return godot::Object::cast_to<LensingTable>(resource.ptr()) != nullptr;
}

godot::PackedStringArray LensingTableSaver::_get_recognized_extensions(
		const godot::Ref<godot::Resource> &resource) const {
	return _recognize(resource) ? table_endings() : godot::PackedStringArray();
}

godot::Error LensingTableSaver::_save(
		const godot::Ref<godot::Resource> &resource, const godot::String &path, uint32_t /*flags*/) {
	const auto *saved = godot::Object::cast_to<LensingTable>(resource.ptr());
	return saved != nullptr ? saved->save_file(path) : godot::ERR_INVALID_PARAMETER;
}
