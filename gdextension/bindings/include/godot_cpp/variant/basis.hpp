// SPDX-License-Identifier: MIT
#pragma once

#include "godot_cpp/variant/quaternion.hpp"
#include "godot_cpp/variant/vector3.hpp"

namespace godot {

// A 3x3 matrix stored by rows; its columns are the axes of a local frame.
struct Basis {
	Vector3 rows[3] = {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)};

	constexpr Basis() = default;
	// From the three axes (columns).
	constexpr Basis(const Vector3 &x_axis, const Vector3 &y_axis, const Vector3 &z_axis) {
		set_columns(x_axis, y_axis, z_axis);
	}
	// From the elements, row by row.
	constexpr Basis(
			real_t xx, real_t xy, real_t xz, real_t yx, real_t yy, real_t yz, real_t zx, real_t zy, real_t zz)
			: rows{Vector3(xx, xy, xz), Vector3(yx, yy, yz), Vector3(zx, zy, zz)} {}
	constexpr Basis(const Quaternion &q)
			: Basis(q.xform(Vector3(1, 0, 0)), q.xform(Vector3(0, 1, 0)), q.xform(Vector3(0, 0, 1))) {}
	// The rotation by `angle` (radians) about a unit axis.
	Basis(const Vector3 &axis, real_t angle) : Basis(Quaternion(axis, angle)) {}

	constexpr const Vector3 &operator[](int row) const { return rows[row]; }
	constexpr Vector3 &operator[](int row) { return rows[row]; }
	constexpr Vector3 get_column(int column) const {
		return {rows[0][column], rows[1][column], rows[2][column]};
	}
	constexpr void set_column(int column, const Vector3 &v) {
		rows[0][column] = v.x;
		rows[1][column] = v.y;
		rows[2][column] = v.z;
	}
	constexpr void set_columns(const Vector3 &x_axis, const Vector3 &y_axis, const Vector3 &z_axis) {
		set_column(0, x_axis);
		set_column(1, y_axis);
		set_column(2, z_axis);
	}

	constexpr Vector3 xform(const Vector3 &v) const {
		return {rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)};
	}
	// The transposed matrix applied: the inverse rotation.
	constexpr Vector3 xform_inv(const Vector3 &v) const {
		return rows[0] * v.x + rows[1] * v.y + rows[2] * v.z;
	}
	constexpr Basis transposed() const { return Basis(rows[0], rows[1], rows[2]); }
	constexpr real_t determinant() const { return rows[0].dot(rows[1].cross(rows[2])); }
	constexpr Basis inverse() const {
		return Basis(rows[1].cross(rows[2]), rows[2].cross(rows[0]), rows[0].cross(rows[1])) *
				(1.0F / determinant());
	}
	// Right-handed unit axes, by Gram and Schmidt from the first on.
	Basis orthonormalized() const {
		const Vector3 x = get_column(0).normalized();
		Vector3 y = get_column(1);
		y = (y - x * x.dot(y)).normalized();
		Vector3 z = get_column(2);
		z = (z - x * x.dot(z) - y * y.dot(z)).normalized();
		return {x, y, z};
	}
	Basis scaled(const Vector3 &scale) const {
		Basis result;
		for (int row = 0; row < 3; ++row) {
			result.rows[row] = rows[row] * scale[row];
		}
		return result;
	}
	Vector3 get_scale_abs() const {
		return {get_column(0).length(), get_column(1).length(), get_column(2).length()};
	}
	bool is_equal_approx(const Basis &b) const {
		return rows[0].is_equal_approx(b.rows[0]) && rows[1].is_equal_approx(b.rows[1]) &&
				rows[2].is_equal_approx(b.rows[2]);
	}

	constexpr Basis operator*(const Basis &b) const {
		return {xform(b.get_column(0)), xform(b.get_column(1)), xform(b.get_column(2))};
	}
	constexpr Basis operator*(real_t factor) const {
		return {get_column(0) * factor, get_column(1) * factor, get_column(2) * factor};
	}
	constexpr bool operator==(const Basis &b) const = default;
};

} // namespace godot
