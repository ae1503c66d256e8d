// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace blackhole::test {

/// Counts the bytes that operator new gives on the calling thread while the meter lives, whether or not they
/// are given back. One at a time.
class AllocationMeter {
public:
	AllocationMeter();
	~AllocationMeter();
	AllocationMeter(const AllocationMeter &) = delete;
	AllocationMeter &operator=(const AllocationMeter &) = delete;

	std::size_t bytes() const;
};

} // namespace blackhole::test
