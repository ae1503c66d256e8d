// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace blackhole {

/// Decides how many rows each of many buffers holds, when each is to hold the first ones of a list and what
/// is needed changes all the time: grows what is too small at once and with some to spare, and takes the
/// spare rows back only where all together hold more than they should. So buffers are made anew seldom, and
/// the rows then written are, over time, a small multiple of the rows by which needs grow.
class BufferPlan {
public:
	BufferPlan() = default;
	/// lengths: rows of each buffer's list. most: rows that all together should not exceed; they do where
	/// more is needed (at worst 1.4 times the need and a few rows each).
	BufferPlan(const std::vector<std::size_t> &lengths, std::size_t most);

	/// From now on this buffer needs the first `rows` of its list. Returns the buffers that must be made
	/// anew, holds() rows long; valid until the next call.
	const std::vector<std::size_t> &need(std::size_t buffer, std::size_t rows);

	std::size_t holds(std::size_t buffer) const { return buffers[buffer].held; }
	/// Rows of all buffers.
	std::size_t total() const { return held_in_all; }
	/// What is needed as a part of the rows that all should not exceed.
	double pressure() const { return static_cast<double>(needed_in_all) / static_cast<double>(most + 1); }

private:
	struct Buffer {
		std::size_t length = 0;
		std::size_t needed = 0;
		std::size_t held = 0;
	};

	void resize(std::size_t buffer, std::size_t rows);
	void take_back(double times);

	std::vector<Buffer> buffers;
	std::vector<std::size_t> changed;
	std::size_t most = 0;
	std::size_t held_in_all = 0;
	std::size_t needed_in_all = 0;
	std::size_t next = 0; ///< whose turn it is to give rows back
};

} // namespace blackhole
