// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace blackhole {

/// A number with its exact first derivatives with respect to N independent variables (forward
/// differentiation). Written once for a formula, it gives the slope without a second formula and without a
/// difference quotient.
template <std::size_t N>
struct Dual {
	double value = 0.0;
	std::array<double, N> slope{};

	Dual() = default;
	explicit constexpr Dual(double constant) : value(constant) {}
	Dual(double number, const std::array<double, N> &slopes) : value(number), slope(slopes) {}

	/// The independent variable with the given index.
	static Dual variable(double number, std::size_t index) {
		Dual result(number);
		result.slope[index] = 1.0;
		return result;
	}
};

/// f(x) given f and df/dx at x.
template <std::size_t N>
Dual<N> chain(const Dual<N> &x, double f, double df) {
	Dual<N> result(f);
	for (std::size_t i = 0; i < N; ++i) {
		result.slope[i] = df * x.slope[i];
	}
	return result;
}

/// f(x, y) given f, df/dx and df/dy.
template <std::size_t N>
Dual<N> chain(const Dual<N> &x, const Dual<N> &y, double f, double df_dx, double df_dy) {
	Dual<N> result(f);
	for (std::size_t i = 0; i < N; ++i) {
		result.slope[i] = df_dx * x.slope[i] + df_dy * y.slope[i];
	}
	return result;
}

template <std::size_t N>
Dual<N> operator-(const Dual<N> &x) {
	return chain(x, -x.value, -1.0);
}
template <std::size_t N>
Dual<N> operator+(const Dual<N> &x, const Dual<N> &y) {
	return chain(x, y, x.value + y.value, 1.0, 1.0);
}
template <std::size_t N>
Dual<N> operator-(const Dual<N> &x, const Dual<N> &y) {
	return chain(x, y, x.value - y.value, 1.0, -1.0);
}
template <std::size_t N>
Dual<N> operator*(const Dual<N> &x, const Dual<N> &y) {
	return chain(x, y, x.value * y.value, y.value, x.value);
}
template <std::size_t N>
Dual<N> operator/(const Dual<N> &x, const Dual<N> &y) {
	const double quotient = x.value / y.value;
	return chain(x, y, quotient, 1.0 / y.value, -quotient / y.value);
}
template <std::size_t N>
Dual<N> operator+(double x, const Dual<N> &y) {
	return chain(y, x + y.value, 1.0);
}
template <std::size_t N>
Dual<N> operator+(const Dual<N> &x, double y) {
	return chain(x, x.value + y, 1.0);
}
template <std::size_t N>
Dual<N> operator-(double x, const Dual<N> &y) {
	return chain(y, x - y.value, -1.0);
}
template <std::size_t N>
Dual<N> operator-(const Dual<N> &x, double y) {
	return chain(x, x.value - y, 1.0);
}
template <std::size_t N>
Dual<N> operator*(double x, const Dual<N> &y) {
	return chain(y, x * y.value, x);
}
template <std::size_t N>
Dual<N> operator/(const Dual<N> &x, double y) {
	return chain(x, x.value / y, 1.0 / y);
}
template <std::size_t N>
Dual<N> operator/(double x, const Dual<N> &y) {
	const double quotient = x / y.value;
	return chain(y, quotient, -quotient / y.value);
}
/// Square root; its slope at 0 is taken as 0 (it is reached only where the slope of the radicand vanishes
/// too).
template <std::size_t N>
Dual<N> sqrt(const Dual<N> &x) {
	const double root = std::sqrt(x.value);
	return chain(x, root, root > 0.0 ? 0.5 / root : 0.0);
}

/// The plain number inside, for decisions that must not depend on slopes.
inline double value_of(double x) {
	return x;
}
template <std::size_t N>
double value_of(const Dual<N> &x) {
	return x.value;
}

} // namespace blackhole
