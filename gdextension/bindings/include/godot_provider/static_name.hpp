// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/string_name.hpp"

#include <atomic>
#include <new>

namespace godot::internal {

// A name kept for the whole time the library is in use. It is made on first use and given back to the engine
// when the bindings shut down, not by a static destructor, which would run after the engine's own end.
class StaticName {
public:
	explicit constexpr StaticName(const char *text) : text_(text) {}
	StaticName(const StaticName &) = delete;
	StaticName &operator=(const StaticName &) = delete;

	const StringName &get() {
		if (!ready_.load(std::memory_order_acquire)) {
			make();
		}
		return *std::launder(reinterpret_cast<const StringName *>(storage_));
	}

	// Gives all names back; each is made anew when asked for again (the engine may reload the library).
	static void release_all();

private:
	void make();

	const char *text_;
	std::atomic<bool> ready_ = false;
	StaticName *next_ = nullptr;
	alignas(StringName) unsigned char storage_[sizeof(StringName)] = {};
};

} // namespace godot::internal
