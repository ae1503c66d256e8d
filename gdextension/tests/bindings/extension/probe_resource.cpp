// SPDX-License-Identifier: MIT
#include "probe_resource.h"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

ProbeResource::ProbeResource() {
	++live_;
}

ProbeResource::~ProbeResource() {
	--live_;
}

void ProbeResource::set_gain(double gain) {
	if (gain == gain_) {
		return;
	}
	gain_ = gain;
	emit_signal("gain_changed", gain_, Ref<ProbeResource>(this));
	emit_changed();
	notify_property_list_changed();
}

// `mode` cannot be edited while the gain is zero.
void ProbeResource::_validate_property(PropertyInfo &property) const {
	if (property.name == StringName("mode") && gain_ == 0.0) {
		property.usage = PROPERTY_USAGE_NO_EDITOR | PROPERTY_USAGE_READ_ONLY;
	}
}

bool ProbeResource::_set(const StringName &name, const Variant &value) {
	if (name == StringName("extra")) {
		extra_ = value;
		return true;
	}
	return false;
}

bool ProbeResource::_get(const StringName &name, Variant &result) const {
	if (name == StringName("extra")) {
		result = extra_;
		return true;
	}
	return false;
}

void ProbeResource::_get_property_list(List<PropertyInfo> *list) const {
	list->push_back(PropertyInfo(Variant::INT, "extra", PROPERTY_HINT_RANGE, "0,9"));
}

void ProbeResource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_gain", "gain"), &ProbeResource::set_gain);
	ClassDB::bind_method(D_METHOD("get_gain"), &ProbeResource::get_gain);
	ClassDB::bind_method(D_METHOD("set_mode", "mode"), &ProbeResource::set_mode);
	ClassDB::bind_method(D_METHOD("get_mode"), &ProbeResource::get_mode);
	ClassDB::bind_method(D_METHOD("set_data", "data"), &ProbeResource::set_data);
	ClassDB::bind_method(D_METHOD("get_data"), &ProbeResource::get_data);
	ClassDB::bind_static_method("ProbeResource", D_METHOD("get_live_count"), &ProbeResource::get_live_count);

	ADD_GROUP("Measures", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "gain", PROPERTY_HINT_RANGE, "0,10,0.1,suffix:dB"), "set_gain",
			"get_gain");
	ADD_SUBGROUP("More", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Static,Rain,Orbit:7"), "set_mode",
			"get_mode");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_FLOAT32_ARRAY, "data"), "set_data", "get_data");
	ADD_SIGNAL(MethodInfo("gain_changed", PropertyInfo(Variant::FLOAT, "gain"),
			PropertyInfo(Variant::OBJECT, "source", PROPERTY_HINT_RESOURCE_TYPE, "ProbeResource")));

	BIND_ENUM_CONSTANT(MODE_STATIC);
	BIND_ENUM_CONSTANT(MODE_RAIN);
	BIND_ENUM_CONSTANT(MODE_ORBIT);
}
