// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace blackhole {

/// Calls work(first, end) for pieces of [0, count) that together are all of it, on all processors, and
/// returns when the last is done. `piece` (at least 1) is the most that one call gets: less than that is not
/// worth a thread. Calls overlap in time, so work must not touch what another piece changes, nor throw.
template <class Work>
void parallel_for(std::size_t count, std::size_t piece, const Work &work) {
	std::atomic<std::size_t> next{0};
	const auto take_turns = [&next, &work, count, piece]() {
		for (std::size_t first = next.fetch_add(piece); first < count; first = next.fetch_add(piece)) {
			work(first, std::min(first + piece, count));
		}
	};
	const std::size_t pieces = (count + piece - 1) / piece;
	const std::size_t processors = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 16);
	std::vector<std::thread> helpers;
	for (std::size_t i = 1; i < std::min(processors, pieces); ++i) {
		helpers.emplace_back(take_turns);
	}
	take_turns();
	for (std::thread &helper : helpers) {
		helper.join();
	}
}

} // namespace blackhole
