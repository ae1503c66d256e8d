// SPDX-License-Identifier: MIT
#include "godot_provider/class_hooks.hpp"

#include <memory>
#include <vector>

namespace godot::internal {

const GDExtensionInstanceBindingCallbacks ClassAccess::kExtensionCallbacks = {
		[](void * /*token*/, void * /*object*/) -> void * { return nullptr; },
		[](void * /*token*/, void * /*object*/, void * /*wrapper*/) {},
		[](void * /*token*/, void * /*wrapper*/, GDExtensionBool /*reference*/) -> GDExtensionBool {
			return 1;
		}};

void ClassAccess::destroy_wrapper(void *wrapper) {
	delete static_cast<Wrapped *>(wrapper);
}

namespace {

// The list the engine sees comes last, with the owner of its texts found from the entry before it.
struct LentList {
	std::vector<PropertyInfo> infos;
	std::unique_ptr<GDExtensionPropertyInfo[]> entries; // entries[0].name points to this object
};

} // namespace

const GDExtensionPropertyInfo *lend_property_list(const List<PropertyInfo> &list, std::uint32_t *count) {
	auto lent = std::make_unique<LentList>();
	lent->infos.assign(list.begin(), list.end());
	*count = static_cast<std::uint32_t>(lent->infos.size());
	lent->entries = std::make_unique<GDExtensionPropertyInfo[]>(lent->infos.size() + 1);
	GDExtensionPropertyInfo *entries = lent->entries.get();
	for (std::size_t index = 0; index < lent->infos.size(); ++index) {
		entries[index + 1] = lent->infos[index]._to_gdextension();
	}
	entries[0].name = lent.release();
	return entries + 1;
}

void take_back_property_list(const GDExtensionPropertyInfo *list) {
	if (list != nullptr) {
		const std::unique_ptr<LentList> lent(static_cast<LentList *>(list[-1].name));
	}
}

PropertyInfo read_property_info(const GDExtensionPropertyInfo &info) {
	PropertyInfo result;
	result.type = static_cast<Variant::Type>(info.type);
	result.name = *static_cast<const StringName *>(info.name);
	result.class_name = *static_cast<const StringName *>(info.class_name);
	result.hint = info.hint;
	result.hint_string = *static_cast<const String *>(info.hint_string);
	result.usage = info.usage;
	return result;
}

void write_property_info(const PropertyInfo &info, GDExtensionPropertyInfo &target) {
	target.type = static_cast<GDExtensionVariantType>(info.type);
	*static_cast<StringName *>(target.name) = info.name;
	*static_cast<StringName *>(target.class_name) = info.class_name;
	target.hint = info.hint;
	*static_cast<String *>(target.hint_string) = info.hint_string;
	target.usage = info.usage;
}

} // namespace godot::internal
