// SPDX-License-Identifier: MIT
#pragma once

#include "core/tables/lensing_tables.h"

#include <cstdint>
#include <string>
#include <vector>

namespace blackhole {

/// One kind of error of the tables against the exact solution.
struct TableError {
	std::string name;
	double limit = 0.0;
	/// 99.9 % of the errors are not larger.
	double permille = 0.0;
	double largest = 0.0;
	/// Where the largest is.
	double u = 0.0;
	double phi = 0.0;
};

/// Errors over random rays with u from 1e-10 to 20 (uniform in ln u) and Phi up to 8 pi (a third each
/// uniform, uniform in ln Phi, and crowded round the Einstein ring Phi = pi), for rain and, outside the
/// horizon, static observers: xi [rad]; xi in parts of min(1e-4 rad, 1e-3 xi); magnification, relative;
/// forward Phi [rad], and the same turned into an error of xi. The tables are read by the shader's own code
/// in single precision.
std::vector<TableError> measure_table_errors(const LensingTables &tables, int samples, std::uint64_t seed);

} // namespace blackhole
