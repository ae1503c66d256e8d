// SPDX-License-Identifier: MIT
// How one C++ type crosses the engine's C interface, in both directions.
//
// Marshal<T> offers
//   kType, kMetadata                the engine's names for T
//   class Out { ptr() }             an argument on its way to the engine
//   class Result { ptr(), take() }  a value the engine returns
//   get(slot)                       an argument that comes from the engine
//   put(slot, value)                a value returned to the engine
//   from_variant(v), accepts(v)     the same from a Variant, which may hold anything
// Integers travel as int64_t, floats as double, bool as one byte, objects as pointers, the rest as
// themselves.
#pragma once

#include "godot_cpp/variant/variant.hpp"

#include <concepts>

namespace godot::internal {

template <class T>
struct Marshal;

template <class T, class Wire, Variant::Type kVariantType, GDExtensionClassMethodArgumentMetadata kMeta>
struct ScalarMarshal {
	static constexpr Variant::Type kType = kVariantType;
	static constexpr GDExtensionClassMethodArgumentMetadata kMetadata = kMeta;

	class Out {
	public:
		explicit Out(const T &value) : wire_(static_cast<Wire>(value)) {}
		const void *ptr() const { return &wire_; }

	private:
		Wire wire_;
	};
	class Result {
	public:
		void *ptr() { return &wire_; }
		T take() { return static_cast<T>(wire_); }

	private:
		Wire wire_ = {};
	};
	static T get(const void *slot) { return static_cast<T>(*static_cast<const Wire *>(slot)); }
	static void put(void *slot, const T &value) { *static_cast<Wire *>(slot) = static_cast<Wire>(value); }
	static bool accepts(const Variant &value) { return Variant::can_convert_strict(value.get_type(), kType); }
};

template <>
struct Marshal<bool>
		: ScalarMarshal<bool, GDExtensionBool, Variant::BOOL, GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE> {
	static bool from_variant(const Variant &value) { return value.booleanize(); }
};

// The engine's name for the width of an integer type.
template <class T>
constexpr GDExtensionClassMethodArgumentMetadata integer_metadata() {
	constexpr int width = sizeof(T) == 8 ? 3 : (sizeof(T) == 4 ? 2 : (sizeof(T) == 2 ? 1 : 0));
	constexpr int first = std::is_signed_v<T> ? GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_INT8
											  : GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_UINT8;
	return static_cast<GDExtensionClassMethodArgumentMetadata>(first + width);
}

template <std::integral T>
struct Marshal<T> : ScalarMarshal<T, std::int64_t, Variant::INT, integer_metadata<T>()> {
	static T from_variant(const Variant &value) { return value; }
};

template <std::floating_point T>
struct Marshal<T> : ScalarMarshal<T, double, Variant::FLOAT,
							sizeof(T) == 4 ? GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_FLOAT
										   : GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_DOUBLE> {
	static T from_variant(const Variant &value) { return value; }
};

template <class T>
requires std::is_enum_v<T>
struct Marshal<T> : ScalarMarshal<T, std::int64_t, Variant::INT, GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE> {
	static T from_variant(const Variant &value) { return value; }
};

template <class T>
struct Marshal<BitField<T>>
		: ScalarMarshal<BitField<T>, std::int64_t, Variant::INT, GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE> {
	static BitField<T> from_variant(const Variant &value) {
		return BitField<T>(static_cast<std::int64_t>(value));
	}
};

// Types the engine lays out exactly as we do: passed by address, never copied on the way in.
template <class T, Variant::Type kVariantType>
struct ValueMarshal {
	static constexpr Variant::Type kType = kVariantType;
	static constexpr GDExtensionClassMethodArgumentMetadata kMetadata =
			GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;

	class Out {
	public:
		explicit Out(const T &value) : value_(&value) {}
		const void *ptr() const { return value_; }

	private:
		const T *value_;
	};
	class Result {
	public:
		void *ptr() { return &value_; }
		T take() { return std::move(value_); }

	private:
		T value_;
	};
	static const T &get(const void *slot) { return *static_cast<const T *>(slot); }
	static void put(void *slot, const T &value) { *static_cast<T *>(slot) = value; }
	static T from_variant(const Variant &value) { return value; }
	static bool accepts(const Variant &value) { return Variant::can_convert_strict(value.get_type(), kType); }
};

#define GODOT_PROVIDER_MARSHAL(type, tag)                                                                    \
	template <>                                                                                              \
	struct Marshal<type> : ValueMarshal<type, Variant::tag> {};
GODOT_PROVIDER_VALUE_TYPES(GODOT_PROVIDER_MARSHAL)
#undef GODOT_PROVIDER_MARSHAL

template <>
struct Marshal<Variant> : ValueMarshal<Variant, Variant::NIL> {
	static const Variant &from_variant(const Variant &value) { return value; }
	static bool accepts(const Variant & /*value*/) { return true; }
};

} // namespace godot::internal
