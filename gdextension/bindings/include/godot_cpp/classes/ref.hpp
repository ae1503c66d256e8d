// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/classes/ref_counted.hpp"
#include "godot_cpp/core/memory.hpp"
#include "godot_cpp/core/object.hpp"

namespace godot {

// Shares ownership of a reference-counted object; the last owner frees it.
template <class T>
class Ref {
public:
	Ref() = default;
	Ref(std::nullptr_t) {}
	Ref(T *object) { take(object); }
	Ref(const Ref &other) { share(other.object_); }
	Ref(Ref &&other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
	template <class U>
	Ref(const Ref<U> &other) {
		share(Object::cast_to<T>(other.ptr()));
	}
	Ref(const Variant &value) { take(Object::cast_to<T>(value.get_validated_wrapper())); }
	~Ref() { unref(); }

	Ref &operator=(const Ref &other) {
		if (object_ != other.object_) {
			Ref copy(other);
			std::swap(object_, copy.object_);
		}
		return *this;
	}
	Ref &operator=(Ref &&other) noexcept {
		std::swap(object_, other.object_);
		return *this;
	}

	// Owns what the engine has counted for us already.
	static Ref _adopt(T *object) {
		Ref result;
		result.object_ = object;
		return result;
	}

	void instantiate() { *this = Ref(memnew(T)); }
	void unref() {
		if (T *object = std::exchange(object_, nullptr); object != nullptr && object->unreference()) {
			memdelete(object);
		}
	}
	void reset() { unref(); }

	T *ptr() const { return object_; }
	T *operator->() const { return object_; }
	T *operator*() const { return object_; }
	bool is_valid() const { return object_ != nullptr; }
	bool is_null() const { return object_ == nullptr; }
	bool operator==(const Ref &other) const { return object_ == other.object_; }
	bool operator!=(const Ref &other) const { return object_ != other.object_; }
	bool operator==(const T *object) const { return object_ == object; }
	bool operator!=(const T *object) const { return object_ != object; }
	bool operator<(const Ref &other) const { return object_ < other.object_; }

private:
	// A new object carries one count that its first owner takes; init_ref() tells the cases apart.
	void take(T *object) {
		if (object != nullptr && object->init_ref()) {
			object_ = object;
		}
	}
	void share(T *object) {
		if (object != nullptr && object->reference()) {
			object_ = object;
		}
	}

	T *object_ = nullptr;
};

} // namespace godot
