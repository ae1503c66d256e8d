// SPDX-License-Identifier: MIT
#include "godot_provider/static_name.hpp"

#include <mutex>

namespace godot::internal {

namespace {

std::mutex names_mutex;
StaticName *first_name = nullptr;

} // namespace

void StaticName::make() {
	const std::lock_guard lock(names_mutex);
	if (ready_.load(std::memory_order_relaxed)) {
		return;
	}
	new (storage_) StringName(text_);
	next_ = first_name;
	first_name = this;
	ready_.store(true, std::memory_order_release);
}

void StaticName::release_all() {
	const std::lock_guard lock(names_mutex);
	while (first_name != nullptr) {
		StaticName *name = first_name;
		first_name = name->next_;
		name->ready_.store(false, std::memory_order_release);
		std::launder(reinterpret_cast<StringName *>(name->storage_))->~StringName();
	}
}

} // namespace godot::internal
