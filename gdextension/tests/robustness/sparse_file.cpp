// SPDX-License-Identifier: MIT
#include "tests/robustness/sparse_file.h"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include <sys/mman.h>
#include <unistd.h>

namespace blackhole::test {

SparseFile::SparseFile(std::string_view p_start, std::size_t p_size)
		: m_path((std::filesystem::temp_directory_path() / "sparse_XXXXXX").string()), m_size(p_size) {
	const int file = mkstemp(m_path.data());
	const bool made = file >= 0 && write(file, p_start.data(), p_start.size()) == ssize_t(p_start.size()) &&
			ftruncate(file, static_cast<off_t>(p_size)) == 0;
	void *const mapped = made ? mmap(nullptr, p_size, PROT_READ, MAP_PRIVATE, file, 0) : MAP_FAILED;
	if (file >= 0) {
		close(file);
	}
	if (mapped == MAP_FAILED) {
		throw std::runtime_error("no sparse file in the temporary folder");
	}
	m_bytes = static_cast<const std::uint8_t *>(mapped);
}

SparseFile::~SparseFile() {
	munmap(const_cast<std::uint8_t *>(m_bytes), m_size);
	std::remove(m_path.c_str());
}

} // namespace blackhole::test
