// SPDX-License-Identifier: MIT
#include "src/lensing_table.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include "core/relativity/shadow.h"
#include "core/tables/ray_texels.h"
#include "core/tables/table_file.h"
#include "src/exact_results.h"
#include "src/float_texture.h"
#include "src/packed_bytes.h"

using namespace godot;

namespace {

// Ten times the size of the largest table that makes sense; read no further.
constexpr int64_t kLargestTable = int64_t(16) << 20;

} // namespace

LensingTable::~LensingTable() {
	bake_cancelled = true;
	if (worker.joinable()) {
		worker.join();
	}
}

Error LensingTable::refuse(const String &message, Error error) {
	error_message = message;
	UtilityFunctions::push_error(message);
	return error;
}

void LensingTable::adopt(blackhole::LensingTables &&p_tables) {
	inverse_texture = make_float_texture(p_tables.inverse, p_tables.columns, p_tables.rows);
	forward_texture = make_float_texture(p_tables.forward, p_tables.columns, p_tables.rows);
	radius_texture = make_float_texture(
			p_tables.ray_texels.radius, blackhole::kRayTexelColumns, blackhole::kRayTexelRows);
	delay_texture = make_float_texture(
			p_tables.ray_texels.delay, blackhole::kRayTexelColumns, blackhole::kRayTexelRows);
	tables = std::make_shared<const blackhole::LensingTables>(std::move(p_tables));
	error_message = String();
	emit_changed();
}

void LensingTable::set_source_file(const String &path) {
	if (path == source_file) {
		return;
	}
	source_file = path;
	if (path.is_empty()) {
		forget();
	} else {
		load_file(path);
	}
}

void LensingTable::forget() {
	inverse_texture.unref();
	forward_texture.unref();
	radius_texture.unref();
	delay_texture.unref();
	tables.reset();
	error_message = String();
	emit_changed();
}

Error LensingTable::load_file(const String &path) {
	source_file = path;
	const Ref<FileAccess> file = FileAccess::open(path, FileAccess::READ);
	if (file.is_null()) {
		return refuse(
				vformat("Lensing table %s cannot be opened. Re-make it with ./run bake, or call bake().",
						path),
				ERR_FILE_CANT_OPEN);
	}
	if (static_cast<int64_t>(file->get_length()) > kLargestTable) {
		return refuse(
				vformat("Lensing table %s is larger than 16 MiB, so it is none. Re-make it with ./run bake.",
						path),
				ERR_FILE_CORRUPT);
	}
	const CharString name = path.utf8();
	// Its start tells of most files that they are none: before memory is asked for all of it.
	const PackedByteArray head = file->get_buffer(static_cast<int64_t>(blackhole::kTableFileHeaderSize));
	const std::string fault =
			blackhole::table_file_fault(bytes_of(head), file->get_length(), name.get_data());
	if (!fault.empty()) {
		return refuse(String::utf8(fault.c_str()), ERR_FILE_CORRUPT);
	}
	file->seek(0);
	const PackedByteArray bytes = file->get_buffer(static_cast<int64_t>(file->get_length()));
	blackhole::Outcome<blackhole::LensingTables> read =
			blackhole::read_lensing_tables(bytes_of(bytes), name.get_data());
	if (!read) {
		return refuse(String::utf8(read.error.c_str()), ERR_FILE_CORRUPT);
	}
	adopt(std::move(*read.value));
	return OK;
}

Error LensingTable::save_file(const String &path) const {
	if (!tables) {
		UtilityFunctions::push_error(
				"LensingTable.save_file: there is no table yet; load or bake one first.");
		return ERR_UNCONFIGURED;
	}
	const std::vector<std::uint8_t> content = blackhole::write_lensing_tables(*tables);
	PackedByteArray bytes;
	bytes.resize(static_cast<int64_t>(content.size()));
	std::copy(content.begin(), content.end(), bytes.ptrw());
	const Ref<FileAccess> file = FileAccess::open(path, FileAccess::WRITE);
	if (file.is_null() || !file->store_buffer(bytes)) {
		UtilityFunctions::push_error(
				vformat("Lensing table %s cannot be written. Check folder and disk.", path));
		return ERR_FILE_CANT_WRITE;
	}
	return OK;
}

void LensingTable::bake() {
	if (baking) {
		return;
	}
	if (worker.joinable()) {
		worker.join();
	}
	baking = true;
	bake_cancelled = false;
	bake_progress = 0.0;
	// The destructor waits for the worker, so `this` outlives it.
	worker = std::thread([this]() {
		blackhole::LensingTables made = blackhole::bake_lensing_tables([this](double progress) {
			bake_progress = progress;
			return !bake_cancelled;
		});
		if (!bake_cancelled) {
			const std::lock_guard<std::mutex> lock(baked_mutex);
			baked = std::move(made);
		}
		call_deferred("_finish_bake");
	});
}

void LensingTable::cancel_bake() {
	bake_cancelled = true;
}

void LensingTable::finish_bake() {
	if (worker.joinable()) {
		worker.join();
	}
	baking = false;
	bake_progress = 1.0;
	std::optional<blackhole::LensingTables> made;
	{
		const std::lock_guard<std::mutex> lock(baked_mutex);
		made.swap(baked);
	}
	if (made) {
		adopt(std::move(*made));
	}
	emit_signal("bake_finished", made.has_value());
}

PackedFloat32Array LensingTable::get_inverse_texels() const {
	return tables ? packed_floats(tables->inverse) : PackedFloat32Array();
}

PackedFloat32Array LensingTable::get_forward_texels() const {
	return tables ? packed_floats(tables->forward) : PackedFloat32Array();
}

double LensingTable::shadow_angle(double radius, Motion motion) {
	if (!(radius > 0.0) || (motion == MOTION_STATIC && radius <= 1.0)) {
		return std::numeric_limits<double>::quiet_NaN();
	}
	return 2.0 * blackhole::shadow_half_angle(1.0 / radius, core_motion(motion));
}

Dictionary LensingTable::star_image(const Vector3 &position, const Vector3 &star, int order, Motion motion) {
	return exact_star_image("LensingTable", position, star, order, core_motion(motion));
}

Dictionary LensingTable::trace(const Vector3 &position, const Vector3 &view_direction, Motion motion) {
	return exact_trace("LensingTable", position, view_direction, core_motion(motion));
}

void LensingTable::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_source_file", "path"), &LensingTable::set_source_file);
	ClassDB::bind_method(D_METHOD("get_source_file"), &LensingTable::get_source_file);
	ClassDB::bind_method(D_METHOD("load_file", "path"), &LensingTable::load_file);
	ClassDB::bind_method(D_METHOD("save_file", "path"), &LensingTable::save_file);
	ClassDB::bind_method(D_METHOD("bake"), &LensingTable::bake);
	ClassDB::bind_method(D_METHOD("cancel_bake"), &LensingTable::cancel_bake);
	ClassDB::bind_method(D_METHOD("_finish_bake"), &LensingTable::finish_bake);
	ClassDB::bind_method(D_METHOD("is_baking"), &LensingTable::is_baking);
	ClassDB::bind_method(D_METHOD("get_bake_progress"), &LensingTable::get_bake_progress);
	ClassDB::bind_method(D_METHOD("is_ready"), &LensingTable::is_ready);
	ClassDB::bind_method(D_METHOD("get_error_message"), &LensingTable::get_error_message);
	ClassDB::bind_method(D_METHOD("get_inverse_texture"), &LensingTable::get_inverse_texture);
	ClassDB::bind_method(D_METHOD("get_forward_texture"), &LensingTable::get_forward_texture);
	ClassDB::bind_method(D_METHOD("get_radius_texture"), &LensingTable::get_radius_texture);
	ClassDB::bind_method(D_METHOD("get_delay_texture"), &LensingTable::get_delay_texture);
	ClassDB::bind_method(D_METHOD("get_inverse_texels"), &LensingTable::get_inverse_texels);
	ClassDB::bind_method(D_METHOD("get_forward_texels"), &LensingTable::get_forward_texels);
	ClassDB::bind_static_method(
			"LensingTable", D_METHOD("shadow_angle", "radius", "motion"), &LensingTable::shadow_angle);
	ClassDB::bind_static_method("LensingTable", D_METHOD("star_image", "position", "star", "order", "motion"),
			&LensingTable::star_image);
	ClassDB::bind_static_method(
			"LensingTable", D_METHOD("trace", "position", "view_direction", "motion"), &LensingTable::trace);

	ADD_PROPERTY(PropertyInfo(Variant::STRING, "source_file", PROPERTY_HINT_FILE, "*.lut"), "set_source_file",
			"get_source_file");
	ADD_SIGNAL(MethodInfo("bake_finished", PropertyInfo(Variant::BOOL, "completed")));
	BIND_ENUM_CONSTANT(MOTION_STATIC);
	BIND_ENUM_CONSTANT(MOTION_RAIN);
	BIND_ENUM_CONSTANT(MOTION_INFALL);
	BIND_ENUM_CONSTANT(MOTION_ORBIT);
	BIND_ENUM_CONSTANT(MOTION_VELOCITY);
}
