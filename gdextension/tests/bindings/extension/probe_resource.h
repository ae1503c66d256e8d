// SPDX-License-Identifier: MIT
// A resource with properties of every kind the project uses; counts its instances.
#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

#include <atomic>

class ProbeResource : public godot::Resource {
	GDCLASS(ProbeResource, godot::Resource)

public:
	enum Mode { MODE_STATIC, MODE_RAIN, MODE_ORBIT = 7 };

	ProbeResource();
	~ProbeResource() override;

	void set_gain(double gain);
	double get_gain() const { return gain_; }
	void set_mode(Mode mode) { mode_ = mode; }
	Mode get_mode() const { return mode_; }
	void set_data(const godot::PackedFloat32Array &data) { data_ = data; }
	godot::PackedFloat32Array get_data() const { return data_; }

	static int get_live_count() { return live_; }

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;
	bool _set(const godot::StringName &name, const godot::Variant &value);
	bool _get(const godot::StringName &name, godot::Variant &result) const;
	void _get_property_list(godot::List<godot::PropertyInfo> *list) const;

private:
	double gain_ = 2.5;
	Mode mode_ = MODE_RAIN;
	int extra_ = 0;
	godot::PackedFloat32Array data_;
	static inline std::atomic<int> live_ = 0;
};

VARIANT_ENUM_CAST(ProbeResource::Mode)
