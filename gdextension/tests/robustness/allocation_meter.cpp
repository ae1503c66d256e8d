// SPDX-License-Identifier: MIT
#include "tests/robustness/allocation_meter.h"

#include <cstdlib>
#include <new>

namespace {

thread_local bool s_counting = false;
thread_local std::size_t s_bytes = 0;

} // namespace

void *operator new(std::size_t p_size) {
	if (s_counting) {
		s_bytes += p_size;
	}
	if (void *const memory = std::malloc(p_size == 0 ? 1 : p_size)) {
		return memory;
	}
	throw std::bad_alloc();
}

void operator delete(void *p_memory) noexcept {
	std::free(p_memory);
}

void operator delete(void *p_memory, std::size_t) noexcept {
	std::free(p_memory);
}

namespace blackhole::test {

AllocationMeter::AllocationMeter() {
	s_bytes = 0;
	s_counting = true;
}

AllocationMeter::~AllocationMeter() {
	s_counting = false;
}

std::size_t AllocationMeter::bytes() const {
	return s_bytes;
}

} // namespace blackhole::test
