// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/core/defs.hpp"
#include "godot_provider/generated/sizes.hpp"
#include "godot_provider/generated/value_types.hpp"
#include "godot_provider/interface.hpp"

#include <concepts>
#include <cstddef>

namespace godot {

class Object;
class Wrapped;
template <class T>
class Ref;

// A value of any of the engine's types.
class Variant {
public:
	// Values as in extension_api.json.
	enum Type {
		NIL,
		BOOL,
		INT,
		FLOAT,
		STRING,
		VECTOR2,
		VECTOR2I,
		RECT2,
		RECT2I,
		VECTOR3,
		VECTOR3I,
		TRANSFORM2D,
		VECTOR4,
		VECTOR4I,
		PLANE,
		QUATERNION,
		AABB,
		BASIS,
		TRANSFORM3D,
		PROJECTION,
		COLOR,
		STRING_NAME,
		NODE_PATH,
		RID,
		OBJECT,
		CALLABLE,
		SIGNAL,
		DICTIONARY,
		ARRAY,
		PACKED_BYTE_ARRAY,
		PACKED_INT32_ARRAY,
		PACKED_INT64_ARRAY,
		PACKED_FLOAT32_ARRAY,
		PACKED_FLOAT64_ARRAY,
		PACKED_STRING_ARRAY,
		PACKED_VECTOR2_ARRAY,
		PACKED_VECTOR3_ARRAY,
		PACKED_COLOR_ARRAY,
		PACKED_VECTOR4_ARRAY,
		VARIANT_MAX
	};

	Variant() { api().variant_new_nil(storage_); }
	Variant(std::nullptr_t) : Variant() {}
	Variant(const Variant &other) { api().variant_new_copy(storage_, other.storage_); }
	Variant(Variant &&other) noexcept;
	~Variant() { api().variant_destroy(storage_); }
	Variant &operator=(const Variant &other);
	Variant &operator=(Variant &&other) noexcept;

	Variant(bool value);
	template <std::integral T>
	Variant(T value) : Variant(FromInteger{}, static_cast<std::int64_t>(value)) {}
	template <std::floating_point T>
	Variant(T value) : Variant(FromFloat{}, static_cast<double>(value)) {}
	template <class T>
	requires std::is_enum_v<T> Variant(T value) : Variant(FromInteger{}, static_cast<std::int64_t>(value)) {}
	Variant(const char *text);
	Variant(const Wrapped *object);
	template <class T>
	Variant(const Ref<T> &object) : Variant(static_cast<const Wrapped *>(object.ptr())) {}
#define GODOT_PROVIDER_FROM(type, tag) Variant(const ::godot::type &value);
	GODOT_PROVIDER_VALUE_TYPES(GODOT_PROVIDER_FROM)
#undef GODOT_PROVIDER_FROM

	// Conversions follow the engine's rules; an impossible one gives the type's default value.
	operator bool() const {
		return booleanize();
	}
	template <std::integral T>
	requires(!std::same_as<T, bool>) operator T() const {
		return static_cast<T>(to_integer());
	}
	template <std::floating_point T>
	operator T() const {
		return static_cast<T>(to_float());
	}
	template <class T>
	requires std::is_enum_v<T>
	operator T() const {
		return static_cast<T>(to_integer());
	}
#define GODOT_PROVIDER_TO(type, tag) operator ::godot::type() const;
	GODOT_PROVIDER_VALUE_TYPES(GODOT_PROVIDER_TO)
#undef GODOT_PROVIDER_TO
	// The object, or null when there is none or it has been freed; Object::cast_to<T>() narrows it.
	operator Object *() const;

	Type get_type() const {
		return static_cast<Type>(api().variant_get_type(storage_));
	}
	bool booleanize() const {
		return api().variant_booleanize(storage_) != 0;
	}
	String stringify() const;
	std::int64_t hash() const {
		return api().variant_hash(storage_);
	}
	Variant duplicate(bool deep = false) const;
	static String get_type_name(Type type);
	static bool can_convert(Type from, Type to);
	static bool can_convert_strict(Type from, Type to);

	bool operator==(const Variant &other) const;
	bool operator!=(const Variant &other) const;
	bool operator<(const Variant &other) const;

	GDExtensionVariantPtr _native_ptr() const {
		return const_cast<std::uint8_t *>(storage_);
	}

	// For the provider itself: the C++ object of an object Variant; null when it has been freed.
	Wrapped *get_validated_wrapper() const;

private:
	struct FromInteger {};
	struct FromFloat {};
	Variant(FromInteger, std::int64_t value);
	Variant(FromFloat, double value);
	std::int64_t to_integer() const;
	double to_float() const;
	static const internal::Interface &api() {
		return internal::api;
	}

	alignas(8) std::uint8_t storage_[internal::kSizeOfVariant];
};

template <class... Values>
Array Array::make(const Values &...values) {
	return Array({Variant(values)...});
}

// The text with each %s, %d, %f ... replaced in turn, as GDScript's % operator does.
template <class... Values>
String vformat(const String &text, const Values &...values) {
	return text % Variant(Array({Variant(values)...}));
}

} // namespace godot

#include "godot_provider/generated/vararg_methods.hpp"
