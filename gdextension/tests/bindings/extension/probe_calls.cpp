// SPDX-License-Identifier: MIT
#include "probe_calls.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

using namespace godot;

TypedArray<Image> ProbeCalls::make_images(int count) {
	TypedArray<Image> images;
	for (int index = 0; index < count; ++index) {
		PackedByteArray bytes;
		bytes.resize(3);
		images.push_back(Image::create_from_data(1, 1, false, Image::FORMAT_RGB8, bytes));
	}
	return images;
}

namespace {

// The value as it comes back from a Variant.
template <class T>
Variant round_trip(const T &value) {
	const Variant variant(value);
	const T back = variant;
	return Variant(back);
}

} // namespace

Array ProbeCalls::convert_all() {
	Array all;
	all.push_back(round_trip(true));
	all.push_back(round_trip(int64_t(-9007199254740993)));
	all.push_back(round_trip(0.1));
	all.push_back(round_trip(String(U"gr\u00fc\u00df \U0001F30C")));
	all.push_back(round_trip(StringName("name")));
	all.push_back(round_trip(NodePath("a/b:c")));
	all.push_back(round_trip(Vector2(1, 2)));
	all.push_back(round_trip(Vector2i(3, 4)));
	all.push_back(round_trip(Rect2(1, 2, 3, 4)));
	all.push_back(round_trip(Vector3(1, 2, 3)));
	all.push_back(round_trip(Vector3i(4, 5, 6)));
	all.push_back(round_trip(Vector4(1, 2, 3, 4)));
	all.push_back(round_trip(Quaternion(0, 0, 0, 1)));
	all.push_back(round_trip(AABB(Vector3(1, 2, 3), Vector3(4, 5, 6))));
	all.push_back(round_trip(Basis(Vector3(0, 1, 0), Vector3(-1, 0, 0), Vector3(0, 0, 1))));
	all.push_back(round_trip(Transform3D(Basis(), Vector3(7, 8, 9))));
	all.push_back(round_trip(Color(0.25F, 0.5F, 0.75F, 1.0F)));
	return all;
}

String ProbeCalls::describe(const String &name, int64_t number, double value) {
	return vformat("%s has %d at %.2f", name, number, value);
}

Dictionary ProbeCalls::text_facts(const String &text) {
	Dictionary facts;
	const CharString bytes = text.utf8();
	facts["bytes"] = static_cast<int64_t>(bytes.length());
	facts["again"] = String::utf8(bytes.get_data());
	facts["joined"] = text + String("!") + String::num_int64(7);
	facts["equal"] = text == String::utf8(bytes.get_data()) && text != String("other");
	facts["name_equal"] = StringName(text) == StringName(text);
	facts["path"] = String("res://a").path_join("b.txt").get_base_dir();
	return facts;
}

Dictionary ProbeCalls::vector_facts() {
	const Basis turn(Vector3(0, 1, 0), static_cast<real_t>(Math::PI / 2.0));
	const Transform3D frame(turn, Vector3(1, 2, 3));
	Dictionary facts;
	facts["turned"] = turn.xform(Vector3(0, 0, 1));
	facts["identity"] = frame * frame.affine_inverse();
	facts["cross"] = Vector3(1, 0, 0).cross(Vector3(0, 1, 0));
	facts["length"] = Vector3(2, 3, 6).length();
	facts["determinant"] = Basis(Vector3(2, 0, 0), Vector3(0, 3, 0), Vector3(0, 0, 4)).determinant();
	facts["column"] = turn.get_column(2);
	return facts;
}

Ref<ProbeResource> ProbeCalls::make_resource(double gain) {
	Ref<ProbeResource> resource;
	resource.instantiate();
	resource->set_gain(gain);
	return resource;
}

int ProbeCalls::get_count_of(const Ref<RefCounted> &object) {
	return object.is_valid() ? object->get_reference_count() : -1;
}

// Copies, moves, casts and drops references; the numbers must come out the same every round.
Dictionary ProbeCalls::churn_references(int rounds) {
	Dictionary facts;
	const int before = ProbeResource::get_live_count();
	for (int round = 0; round < rounds; ++round) {
		Ref<ProbeResource> first = make_resource(round);
		Ref<ProbeResource> second = first;
		const Ref<Resource> base = second;
		const Ref<ProbeResource> down = base;
		const Ref<Image> wrong = base;
		Variant boxed = first;
		const Ref<ProbeResource> unboxed = boxed;
		Array list;
		list.push_back(first);
		list.push_back(boxed);
		facts["shared"] =
				first->get_reference_count(); // first, second, base, down, boxed, unboxed, 2 in list
		facts["wrong_is_null"] = wrong.is_null();
		first.unref();
		second = Ref<ProbeResource>(memnew(ProbeResource));
		second = nullptr;
		boxed = Variant();
		list.clear();
		facts["left"] = base->get_reference_count(); // base, down, unboxed
	}
	facts["leaked"] = ProbeResource::get_live_count() - before;
	return facts;
}

String ProbeCalls::class_of(Object *object) {
	return object == nullptr ? String("null") : object->get_class();
}

bool ProbeCalls::is_alive(int64_t id) {
	return ObjectDB::get_instance(static_cast<uint64_t>(id)) != nullptr;
}

Array ProbeCalls::with_defaults(
		int first, double second, const String &third, const Ref<ProbeResource> &fourth) {
	Array all;
	all.push_back(first);
	all.push_back(second);
	all.push_back(third);
	all.push_back(fourth);
	return all;
}

PackedFloat32Array ProbeCalls::pass_floats(const PackedFloat32Array &values) {
	last_address_ = values.ptr();
	return values;
}

int64_t ProbeCalls::address_of(const PackedFloat32Array &values) {
	return reinterpret_cast<int64_t>(values.ptr());
}

Dictionary ProbeCalls::packed_facts(const PackedFloat32Array &values) {
	Dictionary facts;
	PackedFloat32Array copy = values;
	facts["copy_shares"] = copy.ptr() == values.ptr();
	const Variant boxed(values);
	const PackedFloat32Array unboxed = boxed;
	facts["variant_shares"] = unboxed.ptr() == values.ptr();
	copy.ptrw()[0] = 42.0F;
	facts["write_separates"] = copy.ptr() != values.ptr();
	const float *address = copy.ptr();
	copy[1] = 43.0F;
	copy.ptrw()[2] = 44.0F;
	facts["own_writes_stay"] = copy.ptr() == address;
	const PackedFloat32Array moved = std::move(copy);
	facts["move_keeps"] = moved.ptr() == address;
	double sum = 0.0;
	for (const float value : moved) {
		sum += value;
	}
	facts["sum"] = sum;
	facts["bytes"] = moved.to_byte_array().size();
	return facts;
}

Dictionary ProbeCalls::packed_kinds() {
	Dictionary kinds;
	kinds["byte"] = PackedByteArray({1, 2, 255});
	kinds["int32"] = PackedInt32Array({-1, 2147483647});
	kinds["int64"] = PackedInt64Array({-1, 9007199254740993});
	kinds["float32"] = PackedFloat32Array({0.5F, -2.0F});
	kinds["float64"] = PackedFloat64Array({0.1});
	kinds["string"] = PackedStringArray({String("a"), String("b")});
	kinds["vector2"] = PackedVector2Array({Vector2(1, 2)});
	kinds["vector3"] = PackedVector3Array({Vector3(1, 2, 3)});
	kinds["color"] = PackedColorArray({Color(1, 0, 0)});
	PackedStringArray words;
	words.push_back("x");
	words.ptrw()[0] = words[0] + String("y");
	kinds["word"] = words[0];
	return kinds;
}

Variant ProbeCalls::call_with(const Callable &callable, const Variant &argument) {
	return callable.call(argument);
}

Callable ProbeCalls::callable_of() {
	return callable_mp(this, &ProbeCalls::twice);
}

int ProbeCalls::connect_twice() {
	emissions_ = 0;
	const Callable counter = callable_mp(this, &ProbeCalls::count_emission);
	connect("pulse", counter);
	const bool equal = is_connected("pulse", callable_mp(this, &ProbeCalls::count_emission));
	emit_signal("pulse", 3);
	emit_signal("pulse", 4);
	disconnect("pulse", counter);
	emit_signal("pulse", 100);
	return equal ? emissions_ : -1;
}

void ProbeCalls::leak_on_purpose() {
	int *volatile lost = new int[1000];
	lost = nullptr;
	static_cast<void>(lost);
}

void ProbeCalls::fail_softly(int index) {
	ERR_FAIL_INDEX_MSG(index, 3, "The index must be below three.");
	ERR_FAIL_COND_MSG(index == 2, vformat("Two is refused, not %d.", index));
	WARN_PRINT("Nothing failed.");
}

void ProbeCalls::_bind_methods() {
	ClassDB::bind_method(D_METHOD("pass_bool", "value"), &ProbeCalls::pass_bool);
	ClassDB::bind_method(D_METHOD("pass_int32", "value"), &ProbeCalls::pass_int32);
	ClassDB::bind_method(D_METHOD("pass_uint8", "value"), &ProbeCalls::pass_uint8);
	ClassDB::bind_method(D_METHOD("pass_int64", "value"), &ProbeCalls::pass_int64);
	ClassDB::bind_method(D_METHOD("pass_float", "value"), &ProbeCalls::pass_float);
	ClassDB::bind_method(D_METHOD("pass_double", "value"), &ProbeCalls::pass_double);
	ClassDB::bind_method(D_METHOD("pass_variant", "value"), &ProbeCalls::pass_variant);
	ClassDB::bind_method(D_METHOD("pass_string", "value"), &ProbeCalls::pass_string);
	ClassDB::bind_method(D_METHOD("pass_string_name", "value"), &ProbeCalls::pass_string_name);
	ClassDB::bind_method(D_METHOD("pass_vector2", "value"), &ProbeCalls::pass_vector2);
	ClassDB::bind_method(D_METHOD("pass_vector3", "value"), &ProbeCalls::pass_vector3);
	ClassDB::bind_method(D_METHOD("pass_color", "value"), &ProbeCalls::pass_color);
	ClassDB::bind_method(D_METHOD("pass_transform", "value"), &ProbeCalls::pass_transform);
	ClassDB::bind_method(D_METHOD("pass_array", "value"), &ProbeCalls::pass_array);
	ClassDB::bind_method(D_METHOD("pass_dictionary", "value"), &ProbeCalls::pass_dictionary);
	ClassDB::bind_method(D_METHOD("make_images", "count"), &ProbeCalls::make_images);
	ClassDB::bind_method(D_METHOD("pass_mode", "mode"), &ProbeCalls::pass_mode);
	ClassDB::bind_method(D_METHOD("convert_all"), &ProbeCalls::convert_all);
	ClassDB::bind_method(D_METHOD("describe", "name", "number", "value"), &ProbeCalls::describe);
	ClassDB::bind_method(D_METHOD("text_facts", "text"), &ProbeCalls::text_facts);
	ClassDB::bind_method(D_METHOD("vector_facts"), &ProbeCalls::vector_facts);
	ClassDB::bind_method(D_METHOD("pass_node", "node"), &ProbeCalls::pass_node);
	ClassDB::bind_method(D_METHOD("pass_resource", "resource"), &ProbeCalls::pass_resource);
	ClassDB::bind_method(D_METHOD("make_resource", "gain"), &ProbeCalls::make_resource);
	ClassDB::bind_method(D_METHOD("get_count_of", "object"), &ProbeCalls::get_count_of);
	ClassDB::bind_method(D_METHOD("keep", "object"), &ProbeCalls::keep);
	ClassDB::bind_method(D_METHOD("get_kept"), &ProbeCalls::get_kept);
	ClassDB::bind_method(D_METHOD("churn_references", "rounds"), &ProbeCalls::churn_references);
	ClassDB::bind_method(D_METHOD("class_of", "object"), &ProbeCalls::class_of);
	ClassDB::bind_method(D_METHOD("is_alive", "id"), &ProbeCalls::is_alive);
	ClassDB::bind_method(D_METHOD("with_defaults", "first", "second", "third", "fourth"),
			&ProbeCalls::with_defaults, DEFVAL(1.5), DEFVAL("three"), DEFVAL(Ref<ProbeResource>()));
	ClassDB::bind_static_method("ProbeCalls", D_METHOD("add", "left", "right"), &ProbeCalls::add, DEFVAL(10));
	ClassDB::bind_method(D_METHOD("pass_floats", "values"), &ProbeCalls::pass_floats);
	ClassDB::bind_method(D_METHOD("address_of", "values"), &ProbeCalls::address_of);
	ClassDB::bind_method(D_METHOD("packed_facts", "values"), &ProbeCalls::packed_facts);
	ClassDB::bind_method(D_METHOD("packed_kinds"), &ProbeCalls::packed_kinds);
	ClassDB::bind_method(D_METHOD("call_with", "callable", "argument"), &ProbeCalls::call_with);
	ClassDB::bind_method(D_METHOD("get_doubler"), &ProbeCalls::get_doubler);
	ClassDB::bind_method(D_METHOD("connect_twice"), &ProbeCalls::connect_twice);
	ClassDB::bind_method(D_METHOD("leak_on_purpose"), &ProbeCalls::leak_on_purpose);
	ClassDB::bind_method(D_METHOD("fail_softly", "index"), &ProbeCalls::fail_softly);
	ADD_SIGNAL(MethodInfo("pulse", PropertyInfo(Variant::INT, "step")));
}

void ProbeShape::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_area"), &ProbeShape::get_area);
}
