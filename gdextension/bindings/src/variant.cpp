// SPDX-License-Identifier: MIT
#include "godot_cpp/variant/variant.hpp"

#include "godot_cpp/classes/object.hpp"
#include "godot_provider/builtin.hpp"
#include "godot_provider/wrappers.hpp"

#include <cstring>

namespace godot {

using internal::builtin_functions;

Variant::Variant(Variant &&other) noexcept : Variant() {
	*this = std::move(other);
}

Variant &Variant::operator=(const Variant &other) {
	if (this != &other) {
		internal::api.variant_destroy(storage_);
		internal::api.variant_new_copy(storage_, other.storage_);
	}
	return *this;
}

Variant &Variant::operator=(Variant &&other) noexcept {
	std::swap(storage_, other.storage_); // a Variant holds no pointer to itself
	return *this;
}

Variant::Variant(bool value) {
	GDExtensionBool wire = value ? 1 : 0;
	builtin_functions[BOOL].to_variant(storage_, &wire);
}

Variant::Variant(FromInteger, std::int64_t value) {
	builtin_functions[INT].to_variant(storage_, &value);
}

Variant::Variant(FromFloat, double value) {
	builtin_functions[FLOAT].to_variant(storage_, &value);
}

Variant::Variant(const char *text) : Variant(String(text)) {}

Variant::Variant(const Wrapped *object) {
	GDExtensionObjectPtr pointer = object == nullptr ? nullptr : object->_owner;
	builtin_functions[OBJECT].to_variant(storage_, &pointer);
}

std::int64_t Variant::to_integer() const {
	std::int64_t value = 0;
	builtin_functions[INT].from_variant(&value, _native_ptr());
	return value;
}

double Variant::to_float() const {
	double value = 0.0;
	builtin_functions[FLOAT].from_variant(&value, _native_ptr());
	return value;
}

// The engine's constructor expects raw memory; ours holds a default value, which is released first.
#define GODOT_PROVIDER_CONVERT(type, tag)                                                                    \
	Variant::Variant(const ::godot::type &value) {                                                           \
		builtin_functions[tag].to_variant(storage_, const_cast<::godot::type *>(&value));                    \
	}                                                                                                        \
	Variant::operator ::godot::type() const {                                                                \
		::godot::type value;                                                                                 \
		if (builtin_functions[tag].destroy != nullptr) {                                                     \
			builtin_functions[tag].destroy(&value);                                                          \
		}                                                                                                    \
		builtin_functions[tag].from_variant(&value, _native_ptr());                                          \
		return value;                                                                                        \
	}
GODOT_PROVIDER_VALUE_TYPES(GODOT_PROVIDER_CONVERT)
#undef GODOT_PROVIDER_CONVERT

Wrapped *Variant::get_validated_wrapper() const {
	if (get_type() != OBJECT) {
		return nullptr;
	}
	const GDObjectInstanceID id = internal::api.variant_get_object_instance_id(storage_);
	return internal::wrapper_of(internal::api.object_get_instance_from_id(id));
}

Variant::operator Object *() const {
	return dynamic_cast<Object *>(get_validated_wrapper());
}

String Variant::stringify() const {
	String text;
	internal::api.variant_stringify(storage_, text._native_ptr());
	return text;
}

Variant Variant::duplicate(bool deep) const {
	Variant copy;
	internal::api.variant_duplicate(storage_, copy.storage_, deep ? 1 : 0);
	return copy;
}

String Variant::get_type_name(Type type) {
	String name;
	builtin_functions[STRING].destroy(name._native_ptr());
	internal::api.variant_get_type_name(static_cast<GDExtensionVariantType>(type), name._native_ptr());
	return name;
}

bool Variant::can_convert(Type from, Type to) {
	return internal::api.variant_can_convert(
				   static_cast<GDExtensionVariantType>(from), static_cast<GDExtensionVariantType>(to)) != 0;
}

bool Variant::can_convert_strict(Type from, Type to) {
	return internal::api.variant_can_convert_strict(
				   static_cast<GDExtensionVariantType>(from), static_cast<GDExtensionVariantType>(to)) != 0;
}

namespace {

bool evaluate(GDExtensionVariantOperator operation, const Variant &left, const Variant &right) {
	Variant result;
	GDExtensionBool valid = 0;
	internal::api.variant_evaluate(
			operation, left._native_ptr(), right._native_ptr(), result._native_ptr(), &valid);
	return valid != 0 && result.booleanize();
}

} // namespace

bool Variant::operator==(const Variant &other) const {
	return evaluate(GDEXTENSION_VARIANT_OP_EQUAL, *this, other);
}

bool Variant::operator!=(const Variant &other) const {
	return !(*this == other);
}

bool Variant::operator<(const Variant &other) const {
	return evaluate(GDEXTENSION_VARIANT_OP_LESS, *this, other);
}

} // namespace godot
