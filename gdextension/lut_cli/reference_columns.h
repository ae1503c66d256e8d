// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"
#include "lut_cli/csv_table.h"
#include "lut_cli/ray_source.h"

#include <span>
#include <string>
#include <vector>

namespace blackhole {

/// One kind of reference table: what goes in, what comes out. A row of results starts with the inputs.
struct ReferenceKind {
	/// inverse_static, inverse_rain, forward_static, forward_rain, images, rings, shadow, gshift, deflection,
	/// disk_static, disk_rain, page_thorne or plunging_gas.
	std::string name;
	std::size_t input_count;
	std::vector<std::string> columns;
	/// Empty where the inputs make sense, else what is wrong with them.
	std::string (*reject)(std::span<const double> inputs);
	/// All columns.
	std::vector<double> (*evaluate)(const RaySource &rays, std::span<const double> inputs);
};

/// Every kind there is.
const std::vector<ReferenceKind> &reference_kinds();

/// The kind with this name, or null.
const ReferenceKind *find_reference_kind(const std::string &name);

/// The input rows of `table` for this kind; fails with file and line on a bad row.
Outcome<std::vector<std::vector<double>>> reference_inputs(const ReferenceKind &kind, const CsvTable &table);

} // namespace blackhole
