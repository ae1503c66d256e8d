// SPDX-License-Identifier: MIT
// Methods for every kind of argument and return value, to be called from GDScript.
#pragma once

#include "probe_resource.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/variant.hpp>

class ProbeCalls : public godot::RefCounted {
	GDCLASS(ProbeCalls, godot::RefCounted)

public:
	// Values through and back.
	bool pass_bool(bool value) { return value; }
	int32_t pass_int32(int32_t value) { return value; }
	uint8_t pass_uint8(uint8_t value) { return value; }
	int64_t pass_int64(int64_t value) { return value; }
	float pass_float(float value) { return value; }
	double pass_double(double value) { return value; }
	godot::Variant pass_variant(const godot::Variant &value) { return value; }
	godot::String pass_string(const godot::String &value) { return value; }
	godot::StringName pass_string_name(const godot::StringName &value) { return value; }
	godot::Vector2 pass_vector2(const godot::Vector2 &value) { return value; }
	godot::Vector3 pass_vector3(godot::Vector3 value) { return value; }
	godot::Color pass_color(const godot::Color &value) { return value; }
	godot::Transform3D pass_transform(const godot::Transform3D &value) { return value; }
	godot::Array pass_array(const godot::Array &value) { return value; }
	godot::Dictionary pass_dictionary(const godot::Dictionary &value) { return value; }
	godot::TypedArray<godot::Image> make_images(int count);
	ProbeResource::Mode pass_mode(ProbeResource::Mode mode) { return mode; }

	// Through a Variant inside C++ and back out as the same type.
	godot::Array convert_all();
	godot::String describe(const godot::String &name, int64_t number, double value);
	godot::Dictionary text_facts(const godot::String &text);
	godot::Dictionary vector_facts();

	// Objects and references.
	godot::Node *pass_node(godot::Node *node) { return node; }
	godot::Ref<ProbeResource> pass_resource(const godot::Ref<ProbeResource> &resource) { return resource; }
	godot::Ref<ProbeResource> make_resource(double gain);
	int get_count_of(const godot::Ref<godot::RefCounted> &object);
	void keep(const godot::Ref<godot::RefCounted> &object) { kept_ = object; }
	godot::Ref<godot::RefCounted> get_kept() const { return kept_; }
	godot::Dictionary churn_references(int rounds);
	godot::String class_of(godot::Object *object);
	bool is_alive(int64_t id);

	// Default arguments.
	godot::Array with_defaults(int first, double second = 1.5, const godot::String &third = "three",
			const godot::Ref<ProbeResource> &fourth = nullptr);
	static int add(int left, int right) { return left + right; }

	// Packed arrays: addresses tell whether elements have been copied.
	godot::PackedFloat32Array pass_floats(const godot::PackedFloat32Array &values);
	int64_t address_of(const godot::PackedFloat32Array &values);
	godot::Dictionary packed_facts(const godot::PackedFloat32Array &values);
	godot::Dictionary packed_kinds();

	// Callables and signals.
	godot::Variant call_with(const godot::Callable &callable, const godot::Variant &argument);
	godot::Callable get_doubler() { return callable_of(); }
	int connect_twice();

	// Leaves an allocation behind, so that the tests can show that a leak would be found.
	void leak_on_purpose();

	void fail_softly(int index);

protected:
	static void _bind_methods();

private:
	godot::Callable callable_of();
	int twice(int value) { return 2 * value; }
	void count_emission(int step) { emissions_ += step; }

	godot::Ref<godot::RefCounted> kept_;
	const void *last_address_ = nullptr;
	int emissions_ = 0;
};

// An abstract class and one that can be made.
class ProbeShape : public godot::RefCounted {
	GDCLASS(ProbeShape, godot::RefCounted)

public:
	virtual double get_area() const = 0;

protected:
	static void _bind_methods();
};

class ProbeCircle : public ProbeShape {
	GDCLASS(ProbeCircle, ProbeShape)

public:
	double get_area() const override { return 3.0; }

protected:
	static void _bind_methods() {}
};
