// SPDX-License-Identifier: MIT
// Marshal<T> for objects and references (marshal.hpp says what its members mean).
#pragma once

#include "godot_cpp/classes/ref.hpp"
#include "godot_cpp/variant/typed_array.hpp"
#include "godot_provider/marshal.hpp"

namespace godot::internal {

// An outgoing object: the address of the engine's pointer to it.
class ObjectOut {
public:
	explicit ObjectOut(const Wrapped *object) : pointer_(object == nullptr ? nullptr : object->_owner) {}
	const void *ptr() const { return &pointer_; }

private:
	GDExtensionObjectPtr pointer_;
};

// nil, an empty reference, or a living object that is a T.
template <class T>
bool accepts_object(const Variant &value) {
	if (value.get_type() == Variant::NIL) {
		return true;
	}
	if (value.get_type() != Variant::OBJECT) {
		return false;
	}
	const Wrapped *wrapper = value.get_validated_wrapper();
	if (wrapper == nullptr) {
		return api.variant_get_object_instance_id(value._native_ptr()) == 0; // otherwise it has been freed
	}
	return dynamic_cast<const T *>(wrapper) != nullptr;
}

template <class T>
requires std::is_base_of_v<Wrapped, T>
struct Marshal<T *> {
	static constexpr Variant::Type kType = Variant::OBJECT;
	static constexpr GDExtensionClassMethodArgumentMetadata kMetadata =
			GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;

	class Out : public ObjectOut {
	public:
		explicit Out(T *object) : ObjectOut(object) {}
	};
	class Result {
	public:
		void *ptr() { return &pointer_; }
		T *take() { return dynamic_cast<T *>(wrapper_of(pointer_)); }

	private:
		GDExtensionObjectPtr pointer_ = nullptr;
	};
	static T *get(const void *slot) {
		return dynamic_cast<T *>(wrapper_of(*static_cast<const GDExtensionObjectPtr *>(slot)));
	}
	static void put(void *slot, T *object) {
		*static_cast<GDExtensionObjectPtr *>(slot) = object == nullptr ? nullptr : object->_owner;
	}
	static T *from_variant(const Variant &value) { return dynamic_cast<T *>(value.get_validated_wrapper()); }
	static bool accepts(const Variant &value) { return accepts_object<T>(value); }
};

template <class T>
struct Marshal<Ref<T>> {
	static constexpr Variant::Type kType = Variant::OBJECT;
	static constexpr GDExtensionClassMethodArgumentMetadata kMetadata =
			GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;

	class Out : public ObjectOut {
	public:
		explicit Out(const Ref<T> &object) : ObjectOut(object.ptr()) {}
	};
	class Result { // the engine counts the reference it leaves here
	public:
		void *ptr() { return &pointer_; }
		Ref<T> take() { return Ref<T>::_adopt(dynamic_cast<T *>(wrapper_of(pointer_))); }

	private:
		GDExtensionObjectPtr pointer_ = nullptr;
	};
	static Ref<T> get(const void *slot) {
		return Ref<T>(dynamic_cast<T *>(wrapper_of(*static_cast<const GDExtensionObjectPtr *>(slot))));
	}
	static void put(void *slot, const Ref<T> &object) {
		if (object.is_valid()) { // the slot is an empty reference of the engine's
			api.ref_set_object(slot, object->_owner);
		}
	}
	static Ref<T> from_variant(const Variant &value) { return Ref<T>(value); }
	static bool accepts(const Variant &value) { return accepts_object<T>(value); }
};

template <class T>
struct Marshal<TypedArray<T>> : ValueMarshal<TypedArray<T>, Variant::ARRAY> {
	static TypedArray<T> from_variant(const Variant &value) {
		const Array array = value;
		return TypedArray<T>(array);
	}
};

} // namespace godot::internal
