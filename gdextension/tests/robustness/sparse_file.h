// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace blackhole::test {

/// A file that is as large as one likes and takes no room on the disk: some bytes at its start, zeros after
/// them. Gone with the object.
class SparseFile {
public:
	SparseFile(std::string_view p_start, std::size_t p_size);
	~SparseFile();
	SparseFile(const SparseFile &) = delete;
	SparseFile &operator=(const SparseFile &) = delete;

	const std::string &path() const { return m_path; }
	/// The content, mapped: only what is looked at is read.
	std::span<const std::uint8_t> bytes() const { return {m_bytes, m_size}; }
	std::string_view text() const { return {reinterpret_cast<const char *>(m_bytes), m_size}; }

private:
	std::string m_path;
	const std::uint8_t *m_bytes = nullptr;
	std::size_t m_size = 0;
};

} // namespace blackhole::test
