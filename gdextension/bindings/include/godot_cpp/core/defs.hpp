// SPDX-License-Identifier: MIT
// Names every other header builds on.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#ifdef _WIN32
#define GDE_EXPORT __declspec(dllexport)
#else
#define GDE_EXPORT __attribute__((visibility("default")))
#endif

#define likely(condition) __builtin_expect(!!(condition), 1)
#define unlikely(condition) __builtin_expect(!!(condition), 0)

#define _FORCE_INLINE_ inline __attribute__((always_inline))
#define _ALWAYS_INLINE_ inline __attribute__((always_inline))

namespace godot {

using real_t = float; // the engine's own precision: single

template <class A, class B>
constexpr auto MIN(A a, B b) {
	return a < b ? a : b;
}
template <class A, class B>
constexpr auto MAX(A a, B b) {
	return a > b ? a : b;
}
template <class T, class L, class H>
constexpr T CLAMP(T value, L low, H high) {
	return value < low ? static_cast<T>(low) : (value > high ? static_cast<T>(high) : value);
}
template <class T>
constexpr T ABS(T value) {
	return value < T(0) ? -value : value;
}

// A set of flags of the enumeration T, as the engine stores it.
template <class T>
class BitField {
public:
	constexpr BitField() = default;
	constexpr BitField(T flag) : value_(static_cast<std::int64_t>(flag)) {}
	constexpr BitField(std::int64_t value) : value_(value) {}
	constexpr operator std::int64_t() const { return value_; }
	constexpr bool has_flag(T flag) const { return (value_ & static_cast<std::int64_t>(flag)) != 0; }
	constexpr void set_flag(T flag) { value_ |= static_cast<std::int64_t>(flag); }
	constexpr void clear_flag(T flag) { value_ &= ~static_cast<std::int64_t>(flag); }
	constexpr bool is_empty() const { return value_ == 0; }

private:
	std::int64_t value_ = 0;
};

} // namespace godot
