// SPDX-License-Identifier: MIT
#include "src/star_catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include "core/catalogue/star_csv.h"
#include "core/catalogue/star_file.h"
#include "src/glm_adapter.h"
#include "src/packed_bytes.h"

using namespace godot;

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
// 32 million rows of CSV; a file beyond it is a mistake, not a catalogue.
constexpr int64_t kLargestCatalogue = int64_t(2) << 30;

double right_ascension_of(const glm::dvec3 &direction) {
	const double angle = std::atan2(-direction.z, direction.x);
	return angle < 0.0 ? angle + 2.0 * 3.14159265358979323846 : angle;
}

} // namespace

Error StarCatalogue::refuse(const String &message) {
	error_message = message;
	UtilityFunctions::push_error(message);
	return ERR_FILE_CORRUPT;
}

void StarCatalogue::set_source_file(const String &path) {
	if (path == source_file) {
		return;
	}
	source_file = path;
	if (!path.is_empty()) {
		load_file(path);
	}
}

Error StarCatalogue::load_file(const String &path) {
	source_file = path;
	const Ref<FileAccess> file = FileAccess::open(path, FileAccess::READ);
	if (file.is_null()) {
		refuse(vformat("Star catalogue %s cannot be opened. Check the path; the built-in catalogue is "
					   "res://addons/blackhole_sky/data/hipparcos.stars.",
				path));
		return ERR_FILE_CANT_OPEN;
	}
	if (static_cast<int64_t>(file->get_length()) > kLargestCatalogue) {
		return refuse(vformat("Star catalogue %s is larger than 2 GiB. Split it or thin it out.", path));
	}
	const bool is_csv = path.get_extension().to_lower() == "csv";
	const CharString name = path.utf8();
	const std::string_view file_name(name.get_data());
	// Its start tells of most files that they are none: before memory is asked for all of it.
	const PackedByteArray head = file->get_buffer(
			static_cast<int64_t>(is_csv ? blackhole::kStarCsvHead : blackhole::kStarFileHeaderSize));
	const std::string fault = is_csv
			? blackhole::star_csv_fault(text_of(head), file_name)
			: blackhole::star_file_fault(bytes_of(head), file->get_length(), file_name);
	if (!fault.empty()) {
		return refuse(String::utf8(fault.c_str()));
	}
	file->seek(0);
	const PackedByteArray bytes = file->get_buffer(static_cast<int64_t>(file->get_length()));
	const Error error = read(bytes, path, is_csv);
	if (error == OK) {
		emit_changed();
	}
	return error;
}

Error StarCatalogue::load_bytes(const PackedByteArray &bytes, const String &name) {
	if (bytes.size() > kLargestCatalogue) {
		return refuse(vformat("Star catalogue %s is larger than 2 GiB. Split it or thin it out.", name));
	}
	const Error error = read(bytes, name, !blackhole::is_star_file(bytes_of(bytes)));
	if (error == OK) {
		source_file = String(); // whose stars they no longer are
		emit_changed();
	}
	return error;
}

Error StarCatalogue::read(const PackedByteArray &bytes, const String &name, bool is_csv) {
	const CharString utf8_name = name.utf8();
	const std::string_view called(utf8_name.get_data());
	blackhole::Outcome<blackhole::StarTable> read = is_csv
			? blackhole::read_star_csv(text_of(bytes), called)
			: blackhole::read_star_file(bytes_of(bytes), called);
	if (!read) {
		return refuse(String::utf8(read.error.c_str()));
	}
	stars = std::move(*read.value);
	error_message = String();
	return OK;
}

Error StarCatalogue::save_file(const String &path) const {
	const std::vector<std::uint8_t> content = blackhole::write_star_file(stars);
	PackedByteArray bytes;
	bytes.resize(static_cast<int64_t>(content.size()));
	std::copy(content.begin(), content.end(), bytes.ptrw());
	const Ref<FileAccess> file = FileAccess::open(path, FileAccess::WRITE);
	if (file.is_null() || !file->store_buffer(bytes)) {
		UtilityFunctions::push_error(
				vformat("Star catalogue %s cannot be written. Check folder and disk.", path));
		return ERR_FILE_CANT_WRITE;
	}
	return OK;
}

Error StarCatalogue::set_stars(const PackedVector3Array &directions, const PackedFloat32Array &magnitudes,
		const PackedFloat32Array &temperatures) {
	if (directions.size() != magnitudes.size() ||
			(temperatures.size() != 0 && temperatures.size() != directions.size())) {
		return refuse(
				"StarCatalogue.set_stars: the arrays differ in length; give each star a direction and a "
				"magnitude, and either all temperatures or none.");
	}
	blackhole::StarTable table;
	table.stars.reserve(static_cast<std::size_t>(directions.size()));
	for (int64_t i = 0; i < directions.size(); ++i) {
		const glm::dvec3 direction = to_glm(directions[i]);
		const double length = glm::length(direction);
		const float temperature =
				temperatures.size() != 0 ? temperatures[i] : blackhole::kTemperatureWithoutColour;
		if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(magnitudes[i]) ||
				!(temperature > 0.0F) || !std::isfinite(temperature)) {
			return refuse(
					vformat("StarCatalogue.set_stars: star %d has a direction, magnitude or temperature that "
							"is no number or out of range; nothing was taken over.",
							i));
		}
		blackhole::Star star;
		star.right_ascension = right_ascension_of(direction);
		star.declination = std::asin(std::clamp(direction.y / length, -1.0, 1.0));
		star.v_magnitude = magnitudes[i];
		star.temperature_k = temperature;
		table.stars.push_back(star);
	}
	table.sort_by_magnitude();
	stars = std::move(table);
	source_file = String();
	error_message = String();
	emit_changed();
	return OK;
}

Vector3 StarCatalogue::get_star_direction(int index) const {
	ERR_FAIL_INDEX_V(index, get_star_count(), Vector3());
	return to_godot(blackhole::world_direction(stars.stars[static_cast<std::size_t>(index)]));
}

double StarCatalogue::get_star_magnitude(int index) const {
	ERR_FAIL_INDEX_V(index, get_star_count(), kNothing);
	return stars.stars[static_cast<std::size_t>(index)].v_magnitude;
}

double StarCatalogue::get_star_temperature(int index) const {
	ERR_FAIL_INDEX_V(index, get_star_count(), kNothing);
	return stars.stars[static_cast<std::size_t>(index)].temperature_k;
}

double StarCatalogue::get_star_color_index(int index) const {
	ERR_FAIL_INDEX_V(index, get_star_count(), kNothing);
	return stars.stars[static_cast<std::size_t>(index)].b_minus_v;
}

double StarCatalogue::get_star_parallax(int index) const {
	ERR_FAIL_INDEX_V(index, get_star_count(), kNothing);
	return stars.stars[static_cast<std::size_t>(index)].parallax_mas;
}

int StarCatalogue::get_star_hip(int index) const {
	ERR_FAIL_INDEX_V(index, get_star_count(), 0);
	return static_cast<int>(stars.stars[static_cast<std::size_t>(index)].hip);
}

String StarCatalogue::get_star_name(int index) const {
	ERR_FAIL_INDEX_V(index, get_star_count(), String());
	return String::utf8(stars.name_of(stars.stars[static_cast<std::size_t>(index)]).c_str());
}

int StarCatalogue::find_hip(int hip) const {
	for (std::size_t i = 0; i < stars.stars.size(); ++i) {
		if (static_cast<int>(stars.stars[i].hip) == hip) {
			return static_cast<int>(i);
		}
	}
	return -1;
}

void StarCatalogue::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_source_file", "path"), &StarCatalogue::set_source_file);
	ClassDB::bind_method(D_METHOD("get_source_file"), &StarCatalogue::get_source_file);
	ClassDB::bind_method(D_METHOD("load_file", "path"), &StarCatalogue::load_file);
	ClassDB::bind_method(D_METHOD("save_file", "path"), &StarCatalogue::save_file);
	ClassDB::bind_method(
			D_METHOD("load_bytes", "bytes", "name"), &StarCatalogue::load_bytes, DEFVAL("stars"));
	ClassDB::bind_method(D_METHOD("set_stars", "directions", "magnitudes", "temperatures"),
			&StarCatalogue::set_stars, DEFVAL(PackedFloat32Array()));
	ClassDB::bind_method(D_METHOD("get_star_count"), &StarCatalogue::get_star_count);
	ClassDB::bind_method(D_METHOD("count_to_magnitude", "magnitude"), &StarCatalogue::count_to_magnitude);
	ClassDB::bind_method(D_METHOD("get_error_message"), &StarCatalogue::get_error_message);
	ClassDB::bind_method(D_METHOD("get_star_direction", "index"), &StarCatalogue::get_star_direction);
	ClassDB::bind_method(D_METHOD("get_star_magnitude", "index"), &StarCatalogue::get_star_magnitude);
	ClassDB::bind_method(D_METHOD("get_star_temperature", "index"), &StarCatalogue::get_star_temperature);
	ClassDB::bind_method(D_METHOD("get_star_color_index", "index"), &StarCatalogue::get_star_color_index);
	ClassDB::bind_method(D_METHOD("get_star_parallax", "index"), &StarCatalogue::get_star_parallax);
	ClassDB::bind_method(D_METHOD("get_star_hip", "index"), &StarCatalogue::get_star_hip);
	ClassDB::bind_method(D_METHOD("get_star_name", "index"), &StarCatalogue::get_star_name);
	ClassDB::bind_method(D_METHOD("find_hip", "hip"), &StarCatalogue::find_hip);

	ADD_PROPERTY(PropertyInfo(Variant::STRING, "source_file", PROPERTY_HINT_FILE, "*.stars,*.csv"),
			"set_source_file", "get_source_file");
}
