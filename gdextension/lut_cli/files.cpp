// SPDX-License-Identifier: MIT
#include "lut_cli/files.h"

#include "core/tables/table_file.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>

namespace blackhole {

Outcome<std::string> read_file(const std::string &path, std::size_t limit) {
	std::error_code code;
	const bool folder = std::filesystem::is_directory(path, code);
	std::ifstream file(path, std::ios::binary);
	if (!file || folder) {
		return Outcome<std::string>::failure(path + ": cannot be opened; check the path");
	}
	const auto refused = [&] {
		return Outcome<std::string>::failure(path + ": larger than " + std::to_string(limit) +
				" bytes, so it is not what was asked for; check the path");
	};
	// What is no regular file, such as /dev/stdin, tells no size.
	if (const auto size = std::filesystem::file_size(path, code); !code && size > limit) {
		return refused();
	}
	std::string content;
	char block[65536];
	while (file.read(block, sizeof block) || file.gcount() > 0) {
		content.append(block, static_cast<std::size_t>(file.gcount()));
		if (content.size() > limit) {
			return refused();
		}
	}
	if (file.bad()) {
		return Outcome<std::string>::failure(path + ": cannot be read");
	}
	return Outcome<std::string>::success(std::move(content));
}

std::string write_file(const std::string &path, std::string_view content) {
	std::string failure = path + ": cannot be written; check that its folder exists and is writable";
	std::error_code code;
	if (std::filesystem::exists(path, code) && !std::filesystem::is_regular_file(path, code)) {
		std::ofstream device(path, std::ios::binary); // such as /dev/stdout
		device << content;
		device.close();
		return device ? "" : failure;
	}
	const std::string part = path + ".part";
	std::ofstream file(part, std::ios::binary);
	file << content;
	file.close();
	if (file) {
		std::filesystem::rename(part, path, code);
	}
	if (!file || code) {
		std::filesystem::remove(part, code);
		return failure;
	}
	return {};
}

Outcome<LensingTables> load_table_file(const std::string &path) {
	constexpr std::size_t kLimit = std::size_t{16} << 20;
	const Outcome<std::string> content = read_file(path, kLimit);
	if (!content) {
		return Outcome<LensingTables>::failure(content.error + ". Re-make it with ./run bake.");
	}
	const auto *bytes = reinterpret_cast<const std::uint8_t *>(content.value->data());
	return read_lensing_tables(std::span(bytes, content.value->size()), path);
}

} // namespace blackhole
