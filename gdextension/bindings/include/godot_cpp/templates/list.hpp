// SPDX-License-Identifier: MIT
#pragma once

#include <list>

namespace godot {

// The container _get_property_list() fills.
template <class T>
class List {
public:
	void push_back(const T &value) { values_.push_back(value); }
	void push_front(const T &value) { values_.push_front(value); }
	int size() const { return static_cast<int>(values_.size()); }
	bool is_empty() const { return values_.empty(); }
	void clear() { values_.clear(); }
	auto begin() { return values_.begin(); }
	auto end() { return values_.end(); }
	auto begin() const { return values_.begin(); }
	auto end() const { return values_.end(); }

private:
	std::list<T> values_;
};

} // namespace godot
