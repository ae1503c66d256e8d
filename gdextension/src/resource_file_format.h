// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/variant.hpp>

/// What loader and saver of a resource with a file of its own answer the engine. TResource has load_file()
/// and save_file(), which say themselves what is wrong.
template <class TResource>
class ResourceFileFormat {
	const char *_type;
	const char *_ending;

public:
	/// The class as the engine knows it, and the file's ending in small letters, without the dot.
	constexpr ResourceFileFormat(const char *type, const char *ending) : _type(type), _ending(ending) {}

	[[nodiscard]] godot::PackedStringArray endings() const {
		godot::PackedStringArray listed;
		listed.push_back(_ending);
		return listed;
	}

	[[nodiscard]] bool handles(const godot::StringName &type) const {
		return type == godot::StringName(_type) || type == godot::StringName("Resource");
	}

	/// The class that is in this file; empty for a file of another format.
	[[nodiscard]] godot::String type_of(const godot::String &path) const {
		return path.get_extension().to_lower() == _ending ? _type : "";
	}

	/// The resource, or the error as a number.
	[[nodiscard]] godot::Variant load(const godot::String &path) const {
		godot::Ref<TResource> loaded;
		loaded.instantiate();
		const godot::Error error = loaded->load_file(path);
		return error == godot::OK ? godot::Variant(loaded) : godot::Variant(static_cast<int64_t>(error));
	}

	[[nodiscard]] bool recognizes(const godot::Ref<godot::Resource> &resource) const {
		return godot::Object::cast_to<TResource>(resource.ptr()) != nullptr;
	}

	/// The ending for this resource; none for one of another class.
	[[nodiscard]] godot::PackedStringArray endings_for(const godot::Ref<godot::Resource> &resource) const {
		return recognizes(resource) ? endings() : godot::PackedStringArray();
	}

	[[nodiscard]] godot::Error save(
			const godot::Ref<godot::Resource> &resource, const godot::String &path) const {
		const auto *saved = godot::Object::cast_to<TResource>(resource.ptr());
		return saved != nullptr ? saved->save_file(path) : godot::ERR_INVALID_PARAMETER;
	}
};
