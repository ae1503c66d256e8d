// SPDX-License-Identifier: MIT
// Values whose contents belong to the engine (String, Array, packed arrays ...): storage, life cycle, calls.
#pragma once

#include "godot_provider/interface.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace godot {

class StringName;
class Variant;

namespace internal {

// The engine's functions common to every built-in type, by Variant type.
struct BuiltinFunctions {
	GDExtensionPtrConstructor construct = nullptr;
	GDExtensionPtrConstructor copy = nullptr;
	GDExtensionPtrDestructor destroy = nullptr; // null for plain data
	GDExtensionVariantFromTypeConstructorFunc to_variant = nullptr;
	GDExtensionTypeFromVariantConstructorFunc from_variant = nullptr;
};
extern std::array<BuiltinFunctions, GDEXTENSION_VARIANT_TYPE_VARIANT_MAX> builtin_functions;

// Fills builtin_functions; after load_interface().
void load_builtin_functions();

// The engine's method `name` of a built-in type; `hash` is the one in extension_api.json.
GDExtensionPtrBuiltInMethod builtin_method(
		GDExtensionVariantType type, const char *name, GDExtensionInt hash);

// Fixed-size storage for one engine value, with the value semantics of the engine's type.
template <GDExtensionVariantType kType, std::size_t kSize>
class Builtin {
public:
	static constexpr GDExtensionVariantType kVariantType = kType;

	Builtin() { functions().construct(storage_, nullptr); }
	Builtin(const Builtin &other) {
		const GDExtensionConstTypePtr arguments[] = {other.storage_};
		functions().copy(storage_, arguments);
	}
	Builtin(Builtin &&other) noexcept : Builtin() { swap(other); }
	~Builtin() {
		if (functions().destroy != nullptr) {
			functions().destroy(storage_);
		}
	}
	Builtin &operator=(const Builtin &other) {
		if (this != &other) {
			Builtin copy(other);
			swap(copy);
		}
		return *this;
	}
	Builtin &operator=(Builtin &&other) noexcept {
		swap(other);
		return *this;
	}

	// The engine's view of this value.
	GDExtensionTypePtr _native_ptr() const { return const_cast<std::uint8_t *>(storage_); }

protected:
	// Replaces the value by what the engine's constructor number `index` (extension_api.json) makes.
	void rebuild(std::int32_t index, const GDExtensionConstTypePtr *arguments) {
		if (functions().destroy != nullptr) {
			functions().destroy(storage_);
		}
		api.variant_get_ptr_constructor(kType, index)(storage_, arguments);
	}

	// this <operation> other, for operations that give a truth value.
	bool compare(GDExtensionVariantOperator operation, const Builtin &other) const {
		GDExtensionBool result = 0;
		api.variant_get_ptr_operator_evaluator(operation, kType, kType)(storage_, other.storage_, &result);
		return result != 0;
	}

	// Engine values hold no pointer to themselves, so their bytes can change places.
	void swap(Builtin &other) noexcept {
		std::uint8_t bytes[kSize];
		std::memcpy(bytes, storage_, kSize);
		std::memcpy(storage_, other.storage_, kSize);
		std::memcpy(other.storage_, bytes, kSize);
	}

private:
	static const BuiltinFunctions &functions() { return builtin_functions[kType]; }

	alignas(8) std::uint8_t storage_[kSize] = {};
};

} // namespace internal
} // namespace godot
