// SPDX-License-Identifier: MIT
#include "lut_cli/eval_command.h"

#include "lut_cli/csv_table.h"
#include "lut_cli/files.h"
#include "lut_cli/ray_source.h"
#include "lut_cli/reference_columns.h"

#include <cmath>
#include <cstdio>
#include <memory>

namespace blackhole {
namespace {

void append_number(std::string &text, double number) {
	if (std::isnan(number)) {
		text += "nan";
		return;
	}
	char digits[40];
	const int size = std::snprintf(digits, sizeof digits, "%.17g", number);
	text.append(digits, static_cast<std::size_t>(size));
}

std::string unknown_name(const std::string &name) {
	std::string message = "unknown reference table '" + name + "'; choose one of:";
	for (const ReferenceKind &kind : reference_kinds()) {
		message += " " + kind.name;
	}
	return message;
}

} // namespace

std::string run_eval(const std::string &name, const std::string &in_path, const std::string &out_path,
		const std::string &table_path) {
	const ReferenceKind *kind = find_reference_kind(name);
	if (kind == nullptr) {
		return unknown_name(name);
	}
	const Outcome<CsvTable> table = CsvTable::load(in_path);
	if (!table) {
		return table.error;
	}
	const auto inputs = reference_inputs(*kind, *table.value);
	if (!inputs) {
		return inputs.error;
	}
	Outcome<LensingTables> tables;
	std::unique_ptr<RaySource> rays = std::make_unique<ExactRays>();
	if (!table_path.empty()) {
		tables = load_table_file(table_path);
		if (!tables) {
			return tables.error;
		}
		rays = std::make_unique<TabulatedRays>(*tables.value);
	}
	std::string text;
	for (std::size_t i = 0; i < kind->columns.size(); ++i) {
		text += (i == 0 ? "" : ",") + kind->columns[i];
	}
	for (const std::vector<double> &row : *inputs.value) {
		char separator = '\n';
		for (const double number : kind->evaluate(*rays, row)) {
			text += separator;
			append_number(text, number);
			separator = ',';
		}
	}
	text += '\n';
	return write_file(out_path, text);
}

} // namespace blackhole
