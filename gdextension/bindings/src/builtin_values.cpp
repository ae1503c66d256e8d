// SPDX-License-Identifier: MIT
// The hand-written members of the built-in types the engine keeps: constructors, operators, element access.
#include "godot_cpp/classes/object.hpp"
#include "godot_cpp/variant/variant.hpp"
#include "godot_provider/call.hpp"

#include <string>

namespace godot {

namespace {

const Variant &checked(GDExtensionVariantPtr element) {
	static const Variant nil;
	return element == nullptr ? nil : *static_cast<const Variant *>(element);
}

} // namespace

String::String(const char *latin1) {
	internal::api.string_new_with_latin1_chars(_native_ptr(), latin1); // an empty String owns nothing
}

String::String(const char32_t *text) {
	internal::api.string_new_with_utf32_chars(_native_ptr(), text);
}

String::String(const wchar_t *text) {
	internal::api.string_new_with_wide_chars(_native_ptr(), text);
}

String::String(const StringName &name) {
	const GDExtensionConstTypePtr arguments[] = {name._native_ptr()};
	rebuild(2, arguments);
}

String::String(const NodePath &path) {
	const GDExtensionConstTypePtr arguments[] = {path._native_ptr()};
	rebuild(3, arguments);
}

String String::utf8(const char *text, std::int64_t length) {
	String result;
	internal::api.string_new_with_utf8_chars_and_len(result._native_ptr(), text, length);
	return result;
}

CharString String::utf8() const {
	const GDExtensionInt size = internal::api.string_to_utf8_chars(_native_ptr(), nullptr, 0);
	std::string bytes(static_cast<std::size_t>(size), '\0');
	internal::api.string_to_utf8_chars(_native_ptr(), bytes.data(), size);
	return CharString(std::move(bytes));
}

CharString String::ascii(bool extended) const {
	const GDExtensionInt size = internal::api.string_to_latin1_chars(_native_ptr(), nullptr, 0);
	std::string bytes(static_cast<std::size_t>(size), '\0');
	internal::api.string_to_latin1_chars(_native_ptr(), bytes.data(), size);
	if (!extended) {
		std::replace_if(
				bytes.begin(), bytes.end(), [](char byte) { return static_cast<unsigned char>(byte) > 0x7f; },
				' ');
	}
	return CharString(std::move(bytes));
}

String String::operator+(const String &other) const {
	String result(*this);
	return result += other;
}

String &String::operator+=(const String &other) {
	internal::api.string_operator_plus_eq_string(_native_ptr(), other._native_ptr());
	return *this;
}

String String::operator%(const Variant &arguments) const {
	Variant result;
	GDExtensionBool valid = 0;
	internal::api.variant_evaluate(GDEXTENSION_VARIANT_OP_MODULE, Variant(*this)._native_ptr(),
			arguments._native_ptr(), result._native_ptr(), &valid);
	return valid != 0 ? String(result.stringify()) : String();
}

bool String::operator==(const String &other) const {
	return compare(GDEXTENSION_VARIANT_OP_EQUAL, other);
}

bool String::operator<(const String &other) const {
	return compare(GDEXTENSION_VARIANT_OP_LESS, other);
}

const char32_t &String::operator[](std::int64_t index) const {
	return *internal::api.string_operator_index_const(_native_ptr(), index);
}

StringName::StringName(const char *latin1) {
	internal::api.string_name_new_with_latin1_chars(_native_ptr(), latin1, 0); // an empty name owns nothing
}

StringName::StringName(const String &text) {
	const GDExtensionConstTypePtr arguments[] = {text._native_ptr()};
	rebuild(2, arguments);
}

NodePath::NodePath(const char *text) : NodePath(String(text)) {}

NodePath::NodePath(const String &text) {
	const GDExtensionConstTypePtr arguments[] = {text._native_ptr()};
	rebuild(2, arguments);
}

bool NodePath::operator==(const NodePath &other) const {
	return compare(GDEXTENSION_VARIANT_OP_EQUAL, other);
}

Callable::Callable(const Object *object, const StringName &method) {
	GDExtensionObjectPtr owner = object == nullptr ? nullptr : object->_owner;
	const GDExtensionConstTypePtr arguments[] = {&owner, method._native_ptr()};
	rebuild(2, arguments);
}

Callable::Callable(GDExtensionCallableCustomInfo2 &info) {
	internal::api.callable_custom_create2(_native_ptr(), &info); // an empty Callable owns nothing
}

bool Callable::operator==(const Callable &other) const {
	return compare(GDEXTENSION_VARIANT_OP_EQUAL, other);
}

Signal::Signal(const Object *object, const StringName &signal) {
	GDExtensionObjectPtr owner = object == nullptr ? nullptr : object->_owner;
	const GDExtensionConstTypePtr arguments[] = {&owner, signal._native_ptr()};
	rebuild(2, arguments);
}

Array::Array(std::initializer_list<Variant> values) {
	resize(static_cast<std::int64_t>(values.size()));
	std::int64_t index = 0;
	for (const Variant &value : values) {
		(*this)[index++] = value;
	}
}

const Variant &Array::operator[](std::int64_t index) const {
	return checked(internal::api.array_operator_index_const(_native_ptr(), index));
}

Variant &Array::operator[](std::int64_t index) {
	return const_cast<Variant &>(checked(internal::api.array_operator_index(_native_ptr(), index)));
}

const Variant *Array::ptr() const {
	return static_cast<const Variant *>(internal::api.array_operator_index_const(_native_ptr(), 0));
}

Variant *Array::ptrw() {
	return static_cast<Variant *>(internal::api.array_operator_index(_native_ptr(), 0));
}

const Variant *Array::begin() const {
	return is_empty() ? nullptr : ptr();
}

const Variant *Array::end() const {
	return is_empty() ? nullptr : ptr() + size();
}

bool Array::operator==(const Array &other) const {
	return compare(GDEXTENSION_VARIANT_OP_EQUAL, other);
}

const Variant &Dictionary::operator[](const Variant &key) const {
	return checked(internal::api.dictionary_operator_index_const(_native_ptr(), key._native_ptr()));
}

Variant &Dictionary::operator[](const Variant &key) {
	return *static_cast<Variant *>(internal::api.dictionary_operator_index(_native_ptr(), key._native_ptr()));
}

bool Dictionary::operator==(const Dictionary &other) const {
	return compare(GDEXTENSION_VARIANT_OP_EQUAL, other);
}

} // namespace godot
