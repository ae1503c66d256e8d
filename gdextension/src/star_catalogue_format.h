// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/resource_format_loader.hpp>
#include <godot_cpp/classes/resource_format_saver.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/variant.hpp>

/// Lets the engine load .stars files as StarCatalogue.
class StarCatalogueLoader : public godot::ResourceFormatLoader {
	GDCLASS(StarCatalogueLoader, godot::ResourceFormatLoader)

protected:
	static void _bind_methods() {}

public:
	godot::PackedStringArray _get_recognized_extensions() const override;
	bool _handles_type(const godot::StringName &type) const override;
	godot::String _get_resource_type(const godot::String &path) const override;
	/// The catalogue, or the error; StarCatalogue::load_file() has said what is wrong.
	godot::Variant _load(const godot::String &path, const godot::String &original_path, bool use_sub_threads,
			int32_t cache_mode) const override;
};

/// Lets the engine save a StarCatalogue as a .stars file.
class StarCatalogueSaver : public godot::ResourceFormatSaver {
	GDCLASS(StarCatalogueSaver, godot::ResourceFormatSaver)

protected:
	static void _bind_methods() {}

public:
	bool _recognize(const godot::Ref<godot::Resource> &resource) const override;
	godot::PackedStringArray _get_recognized_extensions(
			const godot::Ref<godot::Resource> &resource) const override;
	godot::Error _save(
			const godot::Ref<godot::Resource> &resource, const godot::String &path, uint32_t flags) override;
};
