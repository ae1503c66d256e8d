// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/string.hpp>

#include "core/catalogue/star.h"

/// A list of stars, brightest first: from a .stars file, from CSV, or from arrays at run time.
class StarCatalogue : public godot::Resource {
	GDCLASS(StarCatalogue, godot::Resource)

	godot::String source_file;
	godot::String error_message;
	blackhole::StarTable stars;

	godot::Error refuse(const godot::String &message);
	godot::Error read(const godot::PackedByteArray &bytes, const godot::String &name, bool is_csv);

protected:
	static void _bind_methods();

public:
	void set_source_file(const godot::String &path);
	godot::String get_source_file() const { return source_file; }

	godot::Error load_file(const godot::String &path);
	godot::Error save_file(const godot::String &path) const;
	/// What is no .stars file is taken for CSV; `name` stands for the file's in messages.
	godot::Error load_bytes(const godot::PackedByteArray &bytes, const godot::String &name);
	godot::Error set_stars(const godot::PackedVector3Array &directions,
			const godot::PackedFloat32Array &magnitudes, const godot::PackedFloat32Array &temperatures);

	int get_star_count() const { return static_cast<int>(stars.stars.size()); }
	int count_to_magnitude(double magnitude) const { return static_cast<int>(stars.count_to(magnitude)); }
	godot::String get_error_message() const { return error_message; }

	godot::Vector3 get_star_direction(int index) const;
	double get_star_magnitude(int index) const;
	double get_star_temperature(int index) const;
	double get_star_color_index(int index) const;
	double get_star_parallax(int index) const;
	int get_star_hip(int index) const;
	godot::String get_star_name(int index) const;
	int find_hip(int hip) const;

	/// The stars themselves, for the layers that draw them.
	const blackhole::StarTable &table() const { return stars; }
};
