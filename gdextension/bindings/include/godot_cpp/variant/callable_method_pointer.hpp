// SPDX-License-Identifier: MIT
// callable_mp(object, &Class::method): a Callable of a C++ method that need not be bound.
#pragma once

#include "godot_cpp/core/method_bind.hpp"

#include <cstring>
#include <memory>

namespace godot {
namespace internal {

// A method of a living object, as the engine sees it. It keeps the object's id, not its address: reloading
// the library gives the object a new C++ instance.
class MethodCallable {
public:
	explicit MethodCallable(const Object *object) : id_(api.object_get_instance_id(object->_owner)) {}
	virtual ~MethodCallable() = default;
	MethodCallable(const MethodCallable &) = delete;
	MethodCallable &operator=(const MethodCallable &) = delete;

	virtual int argument_count() const = 0;
	// Index of the first argument that does not fit, or -1.
	virtual int first_misfit(const Variant *const *arguments) const = 0;
	virtual Variant::Type argument_type(int index) const = 0;
	virtual void invoke(Wrapped &object, const Variant *const *arguments, Variant &result) const = 0;
	virtual bool same_as(const MethodCallable &other) const = 0;

	GDObjectInstanceID id() const { return id_; }

private:
	GDObjectInstanceID id_;
};

// Hands the callable to the engine.
Callable make_callable(std::unique_ptr<MethodCallable> method);

template <class Class, class Function, class Return, class... Arguments>
class TypedMethodCallable : public MethodCallable {
public:
	TypedMethodCallable(const Object *object, Function function)
			: MethodCallable(object), function_(function) {}

	int argument_count() const override { return static_cast<int>(sizeof...(Arguments)); }
	int first_misfit(const Variant *const *arguments) const override {
		return first_misfit_of<Arguments...>(arguments, std::index_sequence_for<Arguments...>());
	}
	Variant::Type argument_type(int index) const override {
		const std::array<Variant::Type, sizeof...(Arguments) + 1> types = {
				Marshal<Plain<Arguments>>::kType...};
		return types[static_cast<std::size_t>(index)];
	}
	void invoke(Wrapped &object, const Variant *const *arguments, Variant &result) const override {
		Class *instance = static_cast<Class *>(&object);
		call_with_variants<Return, Arguments...>(
				arguments, result,
				[instance, this](auto &&...values) -> Return {
					return (instance->*function_)(std::forward<decltype(values)>(values)...);
				},
				std::index_sequence_for<Arguments...>());
	}
	bool same_as(const MethodCallable &other) const override {
		const auto *typed = dynamic_cast<const TypedMethodCallable *>(&other);
		return typed != nullptr && typed->id() == id() && typed->function_ == function_;
	}

private:
	Function function_;
};

} // namespace internal

template <class Instance, class Class, class Return, class... Arguments>
Callable callable_mp(Instance *object, Return (Class::*method)(Arguments...)) {
	using Typed = internal::TypedMethodCallable<Class, decltype(method), Return, Arguments...>;
	return internal::make_callable(std::make_unique<Typed>(object, method));
}
template <class Instance, class Class, class Return, class... Arguments>
Callable callable_mp(const Instance *object, Return (Class::*method)(Arguments...) const) {
	using Typed = internal::TypedMethodCallable<const Class, decltype(method), Return, Arguments...>;
	return internal::make_callable(std::make_unique<Typed>(object, method));
}

} // namespace godot
