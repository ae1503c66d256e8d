// SPDX-License-Identifier: MIT
#include "src/lensing_table_format.h"

#include "src/lensing_table.h"
#include "src/resource_file_format.h"

namespace {

constexpr ResourceFileFormat<LensingTable> kTableFormat("LensingTable", "lut");

} // namespace

godot::PackedStringArray LensingTableLoader::_get_recognized_extensions() const {
	return kTableFormat.endings();
}

bool LensingTableLoader::_handles_type(const godot::StringName &type) const {
	return kTableFormat.handles(type);
}

godot::String LensingTableLoader::_get_resource_type(const godot::String &path) const {
	return kTableFormat.type_of(path);
}

godot::Variant LensingTableLoader::_load(const godot::String &path, const godot::String & /*original_path*/,
		bool /*use_sub_threads*/, int32_t /*cache_mode*/) const {
	return kTableFormat.load(path);
}

bool LensingTableSaver::_recognize(const godot::Ref<godot::Resource> &resource) const {
	return kTableFormat.recognizes(resource);
}

godot::PackedStringArray LensingTableSaver::_get_recognized_extensions(
		const godot::Ref<godot::Resource> &resource) const {
	return kTableFormat.endings_for(resource);
}

godot::Error LensingTableSaver::_save(
		const godot::Ref<godot::Resource> &resource, const godot::String &path, uint32_t /*flags*/) {
	return kTableFormat.save(resource, path);
}
