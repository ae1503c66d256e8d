// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/basis.hpp"

namespace godot {

// A linear map followed by a shift.
struct Transform3D {
	Basis basis;
	Vector3 origin;

	constexpr Transform3D() = default;
	constexpr Transform3D(const Basis &p_basis, const Vector3 &p_origin = Vector3())
			: basis(p_basis), origin(p_origin) {}
	constexpr Transform3D(
			const Vector3 &x_axis, const Vector3 &y_axis, const Vector3 &z_axis, const Vector3 &p_origin)
			: basis(x_axis, y_axis, z_axis), origin(p_origin) {}

	constexpr const Basis &get_basis() const { return basis; }
	constexpr const Vector3 &get_origin() const { return origin; }
	constexpr void set_basis(const Basis &p_basis) { basis = p_basis; }
	constexpr void set_origin(const Vector3 &p_origin) { origin = p_origin; }

	constexpr Vector3 xform(const Vector3 &v) const { return basis.xform(v) + origin; }
	constexpr Transform3D affine_inverse() const {
		const Basis inverse = basis.inverse();
		return {inverse, inverse.xform(-origin)};
	}
	constexpr Transform3D inverse() const { // of a rotation and a shift
		const Basis transposed = basis.transposed();
		return {transposed, transposed.xform(-origin)};
	}
	Transform3D orthonormalized() const { return {basis.orthonormalized(), origin}; }
	bool is_equal_approx(const Transform3D &t) const {
		return basis.is_equal_approx(t.basis) && origin.is_equal_approx(t.origin);
	}

	constexpr Transform3D operator*(const Transform3D &t) const { return {basis * t.basis, xform(t.origin)}; }
	constexpr bool operator==(const Transform3D &t) const = default;
};

} // namespace godot
