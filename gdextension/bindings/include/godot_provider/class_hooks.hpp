// SPDX-License-Identifier: MIT
// The engine's callbacks for one of our classes. Each class of the chain that declares the function is asked,
// the parent first (for notifications the engine says which end comes first).
#pragma once

#include "godot_cpp/classes/wrapped.hpp"

namespace godot::internal {

// A property list handed to the engine; the texts it points to live until it is given back.
const GDExtensionPropertyInfo *lend_property_list(const List<PropertyInfo> &list, std::uint32_t *count);
void take_back_property_list(const GDExtensionPropertyInfo *list);

PropertyInfo read_property_info(const GDExtensionPropertyInfo &info);
void write_property_info(const PropertyInfo &info, GDExtensionPropertyInfo &target);

template <class Pointer>
struct OwnerOf;
template <class Return, class Class, class... Arguments>
struct OwnerOf<Return (Class::*)(Arguments...)> {
	using type = Class;
};
template <class Return, class Class, class... Arguments>
struct OwnerOf<Return (Class::*)(Arguments...) const> {
	using type = Class;
};

template <class T>
T *instance_as(GDExtensionClassInstancePtr instance) {
	return static_cast<T *>(static_cast<Wrapped *>(instance));
}

// Visits the classes of T's chain that are ours and declare the function; `visit(pointer)` returns true to
// stop.
#define GODOT_PROVIDER_CHAIN(function)                                                                       \
	struct Chain##function {                                                                                 \
		template <class T>                                                                                   \
		static constexpr bool declared() {                                                                   \
			return std::is_same_v<typename OwnerOf<decltype(ClassAccess::pointer##function<T>())>::type, T>; \
		}                                                                                                    \
		template <class T>                                                                                   \
		static constexpr bool any() {                                                                        \
			if constexpr (ClassAccess::is_engine_class<T>()) {                                               \
				return false;                                                                                \
			} else {                                                                                         \
				return declared<T>() || any<typename T::parent_type>();                                      \
			}                                                                                                \
		}                                                                                                    \
		template <class T, class Visitor>                                                                    \
		static bool visit(const Visitor &visitor, bool child_first = false) {                                \
			if constexpr (ClassAccess::is_engine_class<T>()) {                                               \
				return false;                                                                                \
			} else {                                                                                         \
				if (!child_first && visit<typename T::parent_type>(visitor, child_first)) {                  \
					return true;                                                                             \
				}                                                                                            \
				if constexpr (declared<T>()) {                                                               \
					if (visitor(ClassAccess::pointer##function<T>())) {                                      \
						return true;                                                                         \
					}                                                                                        \
				}                                                                                            \
				return child_first && visit<typename T::parent_type>(visitor, child_first);                  \
			}                                                                                                \
		}                                                                                                    \
	};
GODOT_PROVIDER_CHAIN(_notification)
GODOT_PROVIDER_CHAIN(_set)
GODOT_PROVIDER_CHAIN(_get)
GODOT_PROVIDER_CHAIN(_get_property_list)
GODOT_PROVIDER_CHAIN(_validate_property)
GODOT_PROVIDER_CHAIN(_property_can_revert)
GODOT_PROVIDER_CHAIN(_property_get_revert)
GODOT_PROVIDER_CHAIN(_to_string)
#undef GODOT_PROVIDER_CHAIN

// The callbacks of class T.
template <class T>
struct ClassHooks {
	static const StringName &name_at(GDExtensionConstStringNamePtr name) {
		return *static_cast<const StringName *>(name);
	}

	static GDExtensionObjectPtr create(void * /*entry*/, GDExtensionBool notify) {
		T *object = ClassAccess::construct<T>();
		if (notify != 0) {
			send_postinitialize(*object);
		}
		return object->_owner;
	}
	static GDExtensionClassInstancePtr recreate(void * /*entry*/, GDExtensionObjectPtr object) {
		return static_cast<Wrapped *>(ClassAccess::reconstruct<T>(object));
	}
	static void free(void * /*entry*/, GDExtensionClassInstancePtr instance) {
		ClassAccess::destroy_wrapper(instance);
	}

	static void notification(
			GDExtensionClassInstancePtr instance, std::int32_t what, GDExtensionBool reversed) {
		Chain_notification::visit<T>(
				[&](auto pointer) {
					(instance_as<T>(instance)->*pointer)(what);
					return false;
				},
				reversed != 0);
	}
	static GDExtensionBool set(GDExtensionClassInstancePtr instance, GDExtensionConstStringNamePtr name,
			GDExtensionConstVariantPtr value) {
		return Chain_set::visit<T>([&](auto pointer) {
			return (instance_as<T>(instance)->*pointer)(name_at(name), *static_cast<const Variant *>(value));
		});
	}
	static GDExtensionBool get(GDExtensionClassInstancePtr instance, GDExtensionConstStringNamePtr name,
			GDExtensionVariantPtr result) {
		return Chain_get::visit<T>([&](auto pointer) {
			return (instance_as<T>(instance)->*pointer)(name_at(name), *static_cast<Variant *>(result));
		});
	}
	static const GDExtensionPropertyInfo *get_property_list(
			GDExtensionClassInstancePtr instance, std::uint32_t *count) {
		List<PropertyInfo> list;
		Chain_get_property_list::visit<T>([&](auto pointer) {
			(instance_as<T>(instance)->*pointer)(&list);
			return false;
		});
		return lend_property_list(list, count);
	}
	static void free_property_list(GDExtensionClassInstancePtr /*instance*/,
			const GDExtensionPropertyInfo *list, std::uint32_t /*count*/) {
		take_back_property_list(list);
	}
	static GDExtensionBool validate_property(
			GDExtensionClassInstancePtr instance, GDExtensionPropertyInfo *property) {
		PropertyInfo info = read_property_info(*property);
		Chain_validate_property::visit<T>([&](auto pointer) {
			(instance_as<T>(instance)->*pointer)(info);
			return false;
		});
		write_property_info(info, *property);
		return 1;
	}
	static GDExtensionBool property_can_revert(
			GDExtensionClassInstancePtr instance, GDExtensionConstStringNamePtr name) {
		return Chain_property_can_revert::visit<T>(
				[&](auto pointer) { return (instance_as<T>(instance)->*pointer)(name_at(name)); });
	}
	static GDExtensionBool property_get_revert(GDExtensionClassInstancePtr instance,
			GDExtensionConstStringNamePtr name, GDExtensionVariantPtr result) {
		return Chain_property_get_revert::visit<T>([&](auto pointer) {
			return (instance_as<T>(instance)->*pointer)(name_at(name), *static_cast<Variant *>(result));
		});
	}
	static void to_string(
			GDExtensionClassInstancePtr instance, GDExtensionBool *valid, GDExtensionStringPtr text) {
		*valid = Chain_to_string::visit<T>(
				[&](auto pointer) {
					*static_cast<String *>(text) = (instance_as<T>(instance)->*pointer)();
					return true;
				},
				true);
	}

	// The engine's description of class T; callbacks that nobody declares stay null.
	static GDExtensionClassCreationInfo5 describe() {
		GDExtensionClassCreationInfo5 info = {};
		info.create_instance_func = &create;
		info.recreate_instance_func = &recreate;
		info.free_instance_func = &free;
		if constexpr (Chain_notification::any<T>()) {
			info.notification_func = &notification;
		}
		if constexpr (Chain_set::any<T>()) {
			info.set_func = &set;
		}
		if constexpr (Chain_get::any<T>()) {
			info.get_func = &get;
		}
		if constexpr (Chain_get_property_list::any<T>()) {
			info.get_property_list_func = &get_property_list;
			info.free_property_list_func = &free_property_list;
		}
		if constexpr (Chain_validate_property::any<T>()) {
			info.validate_property_func = &validate_property;
		}
		if constexpr (Chain_property_can_revert::any<T>()) {
			info.property_can_revert_func = &property_can_revert;
		}
		if constexpr (Chain_property_get_revert::any<T>()) {
			info.property_get_revert_func = &property_get_revert;
		}
		if constexpr (Chain_to_string::any<T>()) {
			info.to_string_func = &to_string;
		}
		return info;
	}
};

} // namespace godot::internal
