// SPDX-License-Identifier: MIT
// What all packed arrays have beyond the engine's methods: direct access to their elements.
#pragma once

#include "godot_provider/interface.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace godot::internal {

// Goes through the elements. Like godot-cpp's it is none of the standard library's iterators: range-based for is its use,
// for algorithms there is ptr().
template <class T>
class PackedIterator {
public:
	explicit PackedIterator(T *element) : element_(element) {}

	T &operator*() const { return *element_; }
	T *operator->() const { return element_; }
	PackedIterator &operator++() {
		++element_;
		return *this;
	}
	bool operator==(const PackedIterator &other) const { return element_ == other.element_; }
	bool operator!=(const PackedIterator &other) const { return element_ != other.element_; }

private:
	T *element_;
};

// Methods: the generated methods of this array type. Access: functions `write` and `read` that give the
// address of element `index`. Copies share their elements until one is written to; reading copies nothing.
template <class Methods, class T, class Access>
class PackedArray : public Methods {
public:
	using value_type = T;

	PackedArray() = default;
	PackedArray(std::initializer_list<T> values) {
		this->resize(static_cast<std::int64_t>(values.size()));
		T *target = ptrw();
		for (const T &value : values) {
			*target++ = value;
		}
	}

	// Elements for reading; null when empty.
	const T *ptr() const { return Access::read(this->_native_ptr(), 0); }
	// Elements for writing, made this array's own first; null when empty.
	T *ptrw() { return Access::write(this->_native_ptr(), 0); }

	const T &operator[](std::int64_t index) const { return *Access::read(this->_native_ptr(), index); }
	T &operator[](std::int64_t index) { return *Access::write(this->_native_ptr(), index); }

	PackedIterator<const T> begin() const { return PackedIterator<const T>(ptr()); }
	PackedIterator<const T> end() const { return PackedIterator<const T>(ptr() + this->size()); }
	PackedIterator<T> begin() { return PackedIterator<T>(ptrw()); }
	PackedIterator<T> end() { return PackedIterator<T>(ptrw() + this->size()); }
};

} // namespace godot::internal
