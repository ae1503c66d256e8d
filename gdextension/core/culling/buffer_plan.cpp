// SPDX-License-Identifier: MIT
#include "core/culling/buffer_plan.h"

#include <algorithm>

namespace blackhole {
namespace {

constexpr std::size_t kFew = 4; // rows not worth counting

std::size_t generous(std::size_t rows) {
	return 2 * rows + 16 * kFew;
}

std::size_t scant(std::size_t rows) {
	return rows + rows / 4 + kFew;
}

} // namespace

BufferPlan::BufferPlan(const std::vector<std::size_t> &lengths, std::size_t p_most)
		: buffers(lengths.size()), most(p_most) {
	for (std::size_t i = 0; i < lengths.size(); ++i) {
		buffers[i].length = lengths[i];
	}
}

const std::vector<std::size_t> &BufferPlan::need(std::size_t buffer, std::size_t rows) {
	changed.clear();
	Buffer &one = buffers[buffer];
	needed_in_all -= one.needed;
	one.needed = std::min(rows, one.length);
	needed_in_all += one.needed;
	if (one.needed > one.held) {
		const std::size_t others = held_in_all - one.held;
		resize(buffer, others + generous(one.needed) <= most ? generous(one.needed) : scant(one.needed));
		// First where it sets free as many rows as it writes again.
		take_back(2.0);
		take_back(1.4);
	} else if (held_in_all > most && one.held > generous(one.needed)) {
		resize(buffer, scant(one.needed));
	}
	return changed;
}

void BufferPlan::resize(std::size_t buffer, std::size_t rows) {
	Buffer &one = buffers[buffer];
	held_in_all -= one.held;
	one.held = std::min(rows, one.length);
	held_in_all += one.held;
	changed.push_back(buffer);
}

/// Makes buffers smaller that hold more than so many times what they need.
void BufferPlan::take_back(double times) {
	for (std::size_t turn = 0; turn < buffers.size() && held_in_all > most; ++turn) {
		const Buffer &one = buffers[next];
		if (one.held > static_cast<std::size_t>(times * static_cast<double>(one.needed)) + 4 * kFew) {
			resize(next, scant(one.needed));
		}
		next = (next + 1) % buffers.size();
	}
}

} // namespace blackhole
